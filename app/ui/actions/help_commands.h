#pragma once

#include <QCoreApplication>

namespace app {

class Command;
class CommandList;

/// The commands of the Help menu.
struct HelpCommands
{
    Q_DECLARE_TR_FUNCTIONS(HelpCommands)

public:
    explicit HelpCommands(CommandList &list);

    Command *keys;
    Command *hint;
    Command *glossary;
    Command *map;
    Command *tour;
    Command *about;
};

}
