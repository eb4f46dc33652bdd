#pragma once

#include <QObject>

namespace app {

class Command;
class CommandList;
class RunEditor;

/// The commands of the Edit menu. Undo and redo name what they change.
class EditCommands : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    EditCommands(RunEditor &editor, CommandList &list);

    Command *const undo;
    Command *const redo;
    Command *const copyText;
    Command *const pasteText;
    Command *const copyPicture;

private:
    void follow();

    RunEditor &m_editor;
};

}
