#pragma once

#include <QMenu>

namespace app {

/// Returns the size of text and controls that the learner chose last, in percent. It holds from the start of the
/// program on, because Qt needs it before the first window.
int storedSize();
/// Returns whether a screen of so many px has room for the window at a size, in percent. It always has for 100.
bool hasRoomFor(int size, QSize screen);

/// A menu of the sizes of text and controls. A size is disabled if the screen is too small for it.
class SizeMenu : public QMenu
{
    Q_OBJECT

public:
    explicit SizeMenu(QWidget *parent);

signals:
    /// The choice takes effect once the window opens again. `sentence` says so.
    void restartWanted(const QString &sentence);
    /// The learner chose the size that the window has.
    void unchanged();

private:
    void choose(int size);
    /// Enables the sizes that fit the screen.
    void follow();

    int m_current; ///< percent
};

}
