#pragma once

#include <QMenu>

class QDockWidget;
class QMainWindow;

namespace app {

class Commands;
class Theme;

/// The menu of where panels stand: unlocked they are dragged by their titles, or one is sent to a side by the keys.
class ArrangeMenu : public QMenu
{
    Q_OBJECT

public:
    /// For the docks that `window` has now. All must outlive it.
    ArrangeMenu(QMainWindow &window, Commands &commands, const Theme &theme);

signals:
    void resetAsked();
    /// A panel stands somewhere else.
    void moved();

private:
    void addPlaces(QDockWidget &panel);
    void move(QDockWidget &panel, Qt::DockWidgetArea area);
    void setMovable(bool movable);

    QMainWindow &m_window;
    const Theme &m_theme;
};

}
