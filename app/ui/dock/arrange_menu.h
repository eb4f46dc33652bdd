#pragma once

#include <QMenu>

class QDockWidget;
class QMainWindow;

namespace app {

class Command;
class Theme;

/// A menu that arranges the panels. Unlocked panels can be dragged by their titles; the menu also moves a
/// panel to a side by keyboard.
class ArrangeMenu : public QMenu
{
    Q_OBJECT

public:
    /// Lists the docks that `window` has now. `unlock` lets the learner drag them; `reset` is shown only. All
    /// arguments must outlive it.
    ArrangeMenu(QMainWindow &window, Command &unlock, Command &reset, const Theme &theme);

signals:
    /// A panel was moved.
    void moved();

private:
    void addPlaces(QDockWidget &panel);
    void move(QDockWidget &panel, Qt::DockWidgetArea area);
    void setMovable(bool movable);

    QMainWindow &m_window;
    const Theme &m_theme;
};

}
