#pragma once

class QMenu;
class QMenuBar;
class QWidget;

namespace app {

struct Commands;
class LessonDesk;
class SandboxCommands;

/// The menus inside others that are more than a list of commands.
struct Submenus
{
    QMenu *recentFiles;
    QMenu *otherRuns;
    QMenu *arrangePanels;
    QMenu *language;
    QMenu *size;
};

/// Returns the menu bar of the window, filled with its commands.
QMenuBar *makeMenuBar(const Commands &commands, const SandboxCommands &sandbox, const LessonDesk &lessons,
                      const Submenus &submenus, QWidget *parent);

}
