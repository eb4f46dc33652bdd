#pragma once

#include <QLabel>

namespace app {

/// The sentence of the status bar. Where it is longer than its room it ends in dots, and its tooltip has all of it.
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
