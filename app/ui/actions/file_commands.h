#pragma once

#include <QCoreApplication>

namespace app {

class Command;
class CommandList;

/// The commands of the File menu.
struct FileCommands
{
    Q_DECLARE_TR_FUNCTIONS(FileCommands)

public:
    explicit FileCommands(CommandList &list);

    Command *startNew;
    Command *open;
    Command *recover; ///< lists scenes that were not saved
    Command *save;
    Command *saveAs;
    Command *keep;    ///< puts the experiment into the gallery
    Command *gallery; ///< shows the gallery
    Command *handIn;  ///< writes the learner's notebook
    Command *exportPicture;
    Command *exportFilm;
    Command *exportWebPage;
    Command *exportHandout; ///< the lesson on paper
    Command *quit;
};

}
