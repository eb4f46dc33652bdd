#pragma once

#include <QCoreApplication>

#include <array>

namespace app {

class Command;
class CommandList;

/// The commands of the View menu.
struct ViewCommands
{
    Q_DECLARE_TR_FUNCTIONS(ViewCommands)

public:
    explicit ViewCommands(CommandList &list);

    /// Returns the commands that choose a mode, in the order of WindowMode.
    std::array<Command *, 3> modes() const { return {learn, measure, build}; }

    Command *learn;
    Command *measure;
    Command *build;
    Command *zoomIn;
    Command *zoomOut;
    Command *fit;
    Command *nextOutside;
    Command *unitCircle;
    Command *lessons;
    Command *lessonRail;
    Command *codeAndParameters;
    Command *energy;
    Command *effects;
    Command *plots;
    Command *stability;
    Command *settling;
    Command *unlockPanels;
    Command *resetPanels;
    Command *dark;
    Command *highContrast;
    Command *lessMotion;
    Command *sceneOnly;
    Command *fullScreen;
};

}
