#pragma once

#include <QMenu>

namespace app {

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
