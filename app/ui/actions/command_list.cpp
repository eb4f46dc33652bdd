#include "app/ui/actions/command_list.h"

#include <QWidget>

namespace app {

QString titleOf(KeyGroup group)
{
    switch (group) {
    case KeyGroup::experiments:
        return CommandList::tr("Experiments");
    case KeyGroup::pictures:
        return CommandList::tr("Pictures and films");
    case KeyGroup::changes:
        return CommandList::tr("Changes");
    case KeyGroup::time:
        return CommandList::tr("Time");
    case KeyGroup::otherRuns:
        return CommandList::tr("Other runs");
    case KeyGroup::steps:
        return CommandList::tr("Steps");
    case KeyGroup::picture:
        return CommandList::tr("Picture");
    case KeyGroup::window:
        return CommandList::tr("Window");
    case KeyGroup::build:
        return CommandList::tr("Build");
    case KeyGroup::plots:
        return CommandList::tr("Plots");
    case KeyGroup::code:
        return CommandList::tr("Code");
    case KeyGroup::accuracy:
        return CommandList::tr("Accuracy");
    }
    return {};
}

Command *CommandList::add(const QString &text, const QList<QKeySequence> &keys, KeyGroup group)
{
    auto *command = new Command(text, keys, &m_window);
    add(*command, group);
    return command;
}

void CommandList::add(Command &command, KeyGroup group)
{
    m_window.addAction(&command);
    m_entries.push_back({&command, group});
}

QString CommandList::obstacleOf(const QKeySequence &keys) const
{
    for (const Entry &entry : m_entries) {
        if (!entry.command->isEnabled() && entry.command->shortcuts().contains(keys))
            return entry.command->obstacle();
    }
    return {};
}

}
