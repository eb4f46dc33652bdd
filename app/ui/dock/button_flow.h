#pragma once

#include <QWidget>

#include <vector>

class QAbstractButton;
class QFrame;

namespace app {

/// A row of buttons that continues in a second line where the width does not suffice. Inside a scroll area it stays in
/// view: while its place in the layout is below the visible part, the buttons are at the bottom edge of that part.
class ButtonFlow : public QWidget
{
    Q_OBJECT

public:
    /// `box` is the widget that the buttons stay inside. It must have the layout of this widget.
    explicit ButtonFlow(QWidget *box);

    /// Adds a button behind the others.
    template <class Button>
    Button *add(const QString &name, const QString &text, const QString &tip)
    {
        auto *button = new Button(m_strip);
        append(*button, name, text, tip);
        return button;
    }
    /// Fits the buttons again. Call it after one of them was shown or hidden, or has another text.
    void refresh();

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void append(QAbstractButton &button, const QString &name, const QString &text, const QString &tip);
    /// Calls `set` with each button that is not hidden and its place, for this width. Returns the height.
    template <class Set>
    int arrange(int width, Set set) const;
    /// Moves the buttons to where they are in view.
    void place();
    void watchScrolling();

    QWidget *m_strip;
    QFrame *m_edge; ///< the line between the buttons and a text behind them
    std::vector<QAbstractButton *> m_buttons;
    QWidget *m_viewport = nullptr; ///< of the scroll area around; null: none
};

}
