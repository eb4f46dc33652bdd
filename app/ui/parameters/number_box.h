#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/parameter.h"

#include <QDoubleSpinBox>
#include <QPointer>
#include <QWindow>

namespace app {

/// A field for a parameter's number. It grows for large numbers. A number that does not fit is shown cut, or rounded after
/// setRounding(true). The tooltip and the field during editing show it in full; the value itself is never
/// rounded. The learner can type numbers outside the parameter's range; the owner clamps them. A click
/// selects the number, so that typing replaces it. Enter and Space commit the typed number: no number
/// contains a space, and the window uses Space as a shortcut. If a click had given the field the focus, the
/// focus then returns to the previous widget. A click elsewhere in the window commits the number, too, even if it
/// leaves the focus here.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    NumberBox(const lessons::Parameter &parameter, const Theme &theme, QWidget *parent = nullptr);
    ~NumberBox() override;

    /// Shows a value without emitting chosen(). Ignored while the learner types.
    void show(double value);
    /// Shows an empty field, for several values at once. A number that is typed is emitted by chosen().
    void showNothing();
    /// Sets whether a number that does not fit is rounded to as many figures as fit, instead of being cut.
    void setRounding(bool rounds);
    /// Returns the number in full, with at least the declared decimals.
    QString exactText(double value) const;

    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
    void stepBy(int steps) override;
    QSize sizeHint() const override { return {minimumWidth(), height_}; }
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// Emitted when the learner enters a number, which may be out of range.
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
    static constexpr int width_ = 62;  ///< six figures, such as 0.0025
    static constexpr int widest_ = 96; ///< ten figures, such as 1000000.25
    static constexpr int height_ = 26;

    void write();
    /// Commits the number typed so far.
    void takeTyped();
    void watchClicks();
    void stopWatchingClicks();
    void remember(QWidget *old, QWidget *now);
    /// Returns the focus to the widget that had it before a click focused this field.
    void giveBack();
    bool fits(const QString &text) const;
    /// Returns the width of the field for the present value, px.
    int wantedWidth() const;
    /// Returns how much an arrow key changes `value`. The sign of `steps` is the direction.
    double stepFrom(double value, int steps) const;

    double m_min;
    double m_max;
    int m_decimals;
    lessons::Scale m_scale;
    bool m_inFull = false; ///< true while it has the focus
    bool m_isEmpty = false;
    bool m_rounds = false;
    QPointer<QWidget> m_before;        ///< had the focus before a click focused this field
    QPointer<QWindow> m_clickedWindow; ///< watched for clicks while the field has the focus
    bool m_byMouse = false;            ///< whether a click gave it the focus
    bool m_isFresh = false;            ///< whether no click has set the text cursor since it got the focus
};

}
