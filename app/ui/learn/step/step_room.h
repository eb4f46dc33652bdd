#pragma once

#include <QScrollArea>
#include <QScrollBar>

class QVBoxLayout;

namespace app {

class ViewKeeper;

/// Shares the room of a panel between the text of a step, the things to try below it, and buttons. The text and the
/// things to try scroll separately, so that the latter stay below the text however much of it there is.
class StepRoom
{
public:
    explicit StepRoom(QWidget &panel);

    /// Returns the parent of what scrolls.
    QWidget *page() const { return m_area->widget(); }
    const QWidget *viewport() const { return m_area->viewport(); }
    QScrollBar &bar() const { return *m_area->verticalScrollBar(); }
    void addText(QVBoxLayout *text);
    /// Adds the things to try and the buttons below the text. Only the things to try scroll, not their heading. Call it once,
    /// after addText().
    void addBelow(QWidget *heading, QWidget *tries, QWidget *buttons);

    /// Gives the text and the things to try the heights that they need. The things to try get less, and scroll, if less
    /// than `leastText` px, and less than the whole text, would be left above them.
    void fit(int leastText);
    /// Returns the height that shows everything at the present width, px.
    int fullHeight() const;
    /// Returns the same height with the text at its scrollable minimum, px.
    int leastHeight() const;

    /// Scrolls to the top of `box`, once the layout is done.
    void showTopOf(const QWidget *box);
    /// Scrolls so that the whole box is in view, or at least its end, and keeps it so until the learner scrolls.
    void showWhole(QWidget *box);
    /// The same for one of the things to try.
    void showTry(QWidget *box);

private:
    int triesHeight() const;
    /// Returns the height of the separating line, the heading and the buttons together, in px.
    int aroundTries() const;

    QWidget &m_panel;
    QScrollArea *m_area;
    ViewKeeper *m_keeper;
    QVBoxLayout *m_scrolled;
    QVBoxLayout *m_column;
    QWidget *m_heading = nullptr;
    QWidget *m_tries = nullptr;
    QScrollArea *m_tryArea = nullptr;
    QWidget *m_buttons = nullptr;
};

}
