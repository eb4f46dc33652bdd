#pragma once

#include "app/ui/actions/command_list.h"
#include "app/ui/actions/edit_commands.h"
#include "app/ui/actions/file_commands.h"
#include "app/ui/actions/help_commands.h"
#include "app/ui/actions/run_commands.h"
#include "app/ui/actions/view_commands.h"

namespace app {

/// The commands of a window, except those of the sandbox. The help page lists them in this order.
struct Commands
{
    /// All arguments must outlive it.
    Commands(QWidget &window, Session &session)
        : list(window), edit(session.editor(), list), run(session, list)
    {
    }

    CommandList list;
    FileCommands file{list};
    EditCommands edit;
    RunCommands run;
    ViewCommands view{list};
    HelpCommands help{list};
};

}
