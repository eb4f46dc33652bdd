#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;

namespace app {

/// The lower part of a dialog that exports something: a bar with the progress, and a message.
class ExportProgress : public QWidget
{
    Q_OBJECT

public:
    /// `name` is the accessible name of the bar.
    explicit ExportProgress(const QString &name, QWidget *parent = nullptr);

    QString message() const;
    void setMessage(const QString &sentence);
    /// Shows how much is done. The bar keeps its room while it is hidden.
    void showDone(int done, int total);
    void hideBar();

private:
    QProgressBar *m_bar;
    QLabel *m_message;
};

}
