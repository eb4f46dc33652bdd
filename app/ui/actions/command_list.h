#pragma once

#include "app/ui/actions/command.h"

#include <QCoreApplication>

#include <vector>

class QWidget;

namespace app {

/// The groups of the help page's key list, with the most important ones first. groupTitles() has the same order.
enum class KeyGroup {
    time,
    picture,
    steps,
    changes,
    code,
    plots,
    otherRuns,
    window,
    accuracy,
    build,
    experiments,
    pictures
};

/// Returns the headings of all groups.
QStringList groupTitles();
/// Returns the heading of a group.
inline QString titleOf(KeyGroup group)
{
    return groupTitles()[static_cast<int>(group)];
}

/// Makes the commands of a window and lists them, so that the help page shows every key that works.
class CommandList
{
    Q_DECLARE_TR_FUNCTIONS(CommandList)

public:
    struct Entry
    {
        Command *command;
        KeyGroup group;
    };

    /// The shortcuts work everywhere in `window`, which owns the commands.
    explicit CommandList(QWidget &window) : m_window(window) {}

    /// Makes a command. Menus show its `text`, with "&" before the letter that chooses it.
    Command *add(const QString &text, const QList<QKeySequence> &keys, KeyGroup group);
    /// Lists a command that a panel made, and lets its shortcut work everywhere in the window.
    void add(Command &command, KeyGroup group);
    /// Returns why the command with this shortcut is disabled; empty if there is none, or no reason.
    QString obstacleOf(const QKeySequence &keys) const;
    const std::vector<Entry> &entries() const { return m_entries; }

private:
    QWidget &m_window;
    std::vector<Entry> m_entries;
};

}
