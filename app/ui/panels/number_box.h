#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/parameter.h"

#include <QDoubleSpinBox>
#include <QPointer>

namespace app {

/// A field for a parameter's number. What does not fit is shown cut or, where setRounding() says so, rounded; it is whole
/// in the tooltip and while it is edited. The value itself is never rounded. Numbers outside the parameter's range can
/// be typed; the owner brings them into it. A click selects the number, so that typing replaces it. Enter takes what was
/// typed; so does Space, which no number has and the window has a use for. Then who came by the mouse is back where the
/// keys were before.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    NumberBox(const lessons::Parameter &parameter, const Theme &theme, QWidget *parent = nullptr);
    ~NumberBox() override;

    /// Shows a value without chosen(). While the learner types, it waits.
    void show(double value);
    /// Shows nothing, as where several values are meant; a number that is typed is chosen.
    void showNothing();
    /// Shows a number that does not fit with as many figures as do, in place of cutting it.
    void setRounding(bool rounds);
    /// Takes what was typed so far.
    void takeTyped();
    /// The number in full, with at least the declared decimals.
    QString exactText(double value) const;

    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
    void stepBy(int steps) override;
    QSize sizeHint() const override { return {width_, height_}; }
    QSize minimumSizeHint() const override { return {width_, height_}; }

signals:
    /// The learner gave a number, which may be out of range.
    void chosen(double value);

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }

private:
    static constexpr int width_ = 62; ///< six figures, such as 0.0025
    static constexpr int height_ = 26;

    void dress();
    void write();
    void remember(QWidget *old, QWidget *now);
    /// Gives the keyboard to what had it before a click came here.
    void giveBack();
    bool fits(const QString &text) const;
    /// By how much a press of an arrow key changes `value`; `steps` says which way.
    double stepFrom(double value, int steps) const;

    const Theme &m_theme;
    double m_min;
    double m_max;
    int m_decimals;
    lessons::Scale m_scale;
    bool m_inFull = false; ///< while it has the focus
    bool m_isEmpty = false;
    bool m_rounds = false;
    QPointer<QWidget> m_before; ///< what had the keyboard before a click came here
    bool m_byMouse = false;     ///< whether a click gave it the keyboard
    bool m_isFresh = false; ///< whether no click has put a cursor into the number since it got the keyboard
};

}
