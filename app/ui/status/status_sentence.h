#pragma once

#include <QLabel>

namespace app {

/// The sentence of the status bar. A sentence that does not fit ends in an ellipsis, and its tooltip shows it
/// in full.
class StatusSentence : public QLabel
{
    Q_OBJECT

public:
    explicit StatusSentence(QWidget *parent = nullptr);

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    bool isCut() const;
    QString plain() const;
};

}
