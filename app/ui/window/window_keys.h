#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace app {

class CommandList;
class Session;

/// Decides what a key does in a window: a shortcut takes it, or the widget with the focus. Keeps the focus in sight.
class WindowKeys : public QObject
{
public:
    /// Watches `window` until this object is deleted. `scene` gets the focus of a widget that hides.
    WindowKeys(QWidget &window, QWidget &scene, const CommandList &commands, Session &session);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool isForFocus(const QKeyEvent &key) const;
    bool showObstacle(const QKeyEvent &key) const;
    void followFocus(const QWidget *before, const QWidget *now) const;

    QWidget &m_window;
    QWidget &m_scene;
    const CommandList &m_commands;
    Session &m_session;
};

}
