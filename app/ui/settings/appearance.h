#pragma once

#include "app/ui/theme/theme.h"

#include <QObject>

class QActionGroup;
class QMainWindow;

namespace app {

class Command;
class SceneBar;
class SceneView;
struct ViewCommands;

/// Returns the colours that the learner chose last; light at first.
Scheme storedScheme();

/// Applies and stores the learner's choice of colours and motion, and of what the scene shows.
class Appearance : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    Appearance(QMainWindow &window, SceneBar &bar, SceneView &scene, const ViewCommands &commands,
               Theme &theme);

private:
    void addScheme(QActionGroup &group, Command &command, Scheme scheme);
    /// Stops or allows what moves only as decoration.
    void setLessMotion(bool isLess);
    void rememberShown(SceneBar &bar);
    /// Disables the command in steps without an angle.
    void followAngle(Command &unitCircle) const;

    QMainWindow &m_window;
    SceneView &m_scene;
    Theme &m_theme;
};

}
