#pragma once

#include <QList>
#include <QObject>

namespace app {

class Command;
class CommandList;
class SandboxEditor;
class Session;
enum class BuildTool;

/// The commands of the sandbox, and the one that takes a scene there. They follow whether a sandbox is open.
class SandboxCommands : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    SandboxCommands(Session &session, SandboxEditor &editor, CommandList &list);

    Command *const take;
    Command *const deleteChosen;
    Command *const duplicateChosen;
    Command *const chooseAll;
    Command *const rule;       ///< shows the learner's rule
    Command *const linkChosen; ///< links the selected points by the rule
    /// Returns the commands that choose a tool, in the order of BuildTool.
    const QList<Command *> &tools() const { return m_tools; }

private:
    void addTools(CommandList &list);
    void addTool(CommandList &list, BuildTool tool, const QString &text, const QString &name, const char *key,
                 const QString &help, const char *icon);
    void follow();

    Session &m_session;
    SandboxEditor &m_editor;
    QList<Command *> m_tools;
};

}
