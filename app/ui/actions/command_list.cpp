#include "app/ui/actions/command_list.h"

#include <QWidget>

namespace app {

QStringList groupTitles()
{
    return {
        CommandList::tr("Time"),       CommandList::tr("Picture"),     CommandList::tr("Steps"),
        CommandList::tr("Changes"),    CommandList::tr("Code"),        CommandList::tr("Plots"),
        CommandList::tr("Other runs"), CommandList::tr("Window"),      CommandList::tr("Accuracy"),
        CommandList::tr("Build"),      CommandList::tr("Experiments"), CommandList::tr("Pictures and films")};
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
