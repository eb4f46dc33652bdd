#pragma once

#include "app/ui/theme/theme.h"

#include <QObject>
#include <QSize>

#include <vector>

class QActionGroup;
class QMainWindow;

namespace app {

class Command;
class SceneBar;
class SceneView;
struct ViewCommands;

/// Returns the colours that the learner chose last; light at first.
Scheme storedScheme();
/// Returns the size of text and controls that the learner chose last, in percent. It holds from the start of the
/// program on, because Qt needs it before the first window.
int storedSize();
/// Returns the sizes that a learner can choose, in percent.
std::vector<int> sizes();
/// Stores the size that the learner chose, in percent.
void storeSize(int size);
/// Returns whether a screen of so many px has room for the window at a size, in percent. It always has for 100.
bool hasRoomFor(int size, QSize screen);

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
