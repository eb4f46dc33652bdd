#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/explanation.h"

#include <QAbstractButton>

namespace app {

class WhyText;

/// A button with the question of a why-box. A click, Space or Enter unfolds the answer.
class WhyButton : public QAbstractButton
{
    Q_OBJECT

public:
    WhyButton(const QString &question, const Theme &theme, QWidget *parent = nullptr);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void describeState();

    const Theme &m_theme;
};

/// A question about the mathematics of a step, with an answer that is folded until the learner unfolds it.
class WhyBox : public QWidget
{
    Q_OBJECT

public:
    WhyBox(const lessons::Why &why, const Theme &theme, QWidget *parent = nullptr);

signals:
    void unfolded(bool open);
    /// Emitted when a formula of the answer highlights other things. Empty: nothing.
    void highlightsChanged(const std::vector<lessons::Highlight> &highlights);

private:
    WhyButton *m_button;
    WhyText *m_answer;
};

}
