#pragma once

class QMenu;
class QMenuBar;
class QWidget;

namespace app {

class Command;
struct Commands;
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

/// Returns the menu bar of the window, filled with its commands. `newLesson` begins a lesson.
QMenuBar *makeMenuBar(const Commands &commands, const SandboxCommands &sandbox, Command &newLesson,
                      const Submenus &submenus, QWidget *parent);

}
