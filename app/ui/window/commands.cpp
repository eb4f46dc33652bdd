#include "app/ui/window/commands.h"

#include <QWidget>

namespace app {

QString titleOf(KeyGroup group)
{
    switch (group) {
    case KeyGroup::experiments:
        return Commands::tr("Experiments");
    case KeyGroup::pictures:
        return Commands::tr("Pictures and films");
    case KeyGroup::changes:
        return Commands::tr("Changes");
    case KeyGroup::time:
        return Commands::tr("Time");
    case KeyGroup::otherRuns:
        return Commands::tr("Other runs");
    case KeyGroup::steps:
        return Commands::tr("Steps");
    case KeyGroup::picture:
        return Commands::tr("Picture");
    case KeyGroup::window:
        return Commands::tr("Window");
    case KeyGroup::build:
        return Commands::tr("Build");
    case KeyGroup::plots:
        return Commands::tr("Plots");
    case KeyGroup::code:
        return Commands::tr("Code");
    case KeyGroup::accuracy:
        return Commands::tr("Accuracy");
    }
    return {};
}

QAction *Commands::add(const QString &text, const QList<QKeySequence> &keys, KeyGroup group)
{
    auto *action = new QAction(text, &m_window);
    action->setShortcuts(keys);
    QString plain = text;
    plain.remove('&');
    if (!keys.isEmpty())
        action->setToolTip(tr("%1 (%2)").arg(plain, keys.front().toString(QKeySequence::NativeText)));
    m_window.addAction(action);
    list(action, group);
    return action;
}

}
