#include "app/ui/parameters/grouped_choice.h"

#include "lessons/api/parameter.h"

#include <QMenu>

#include <algorithm>

namespace app {

GroupedChoice::GroupedChoice(const QStringList &titles, QWidget *parent) : QComboBox(parent)
{
    for (const QString &title : titles)
        m_groups << lessons::groupOf(title);
}

void GroupedChoice::showPopup()
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (int first = 0; first < count() && first < m_groups.size();)
        first = addGroup(*menu, first);
    menu->popup(mapToGlobal(QPoint(0, height())));
    for (QAction *group : menu->actions()) { // keyboard navigation starts at the current item
        const QList<QAction *> items = group->menu()->actions();
        if (std::any_of(items.begin(), items.end(), [](const QAction *one) { return one->isChecked(); }))
            menu->setActiveAction(group);
    }
}

int GroupedChoice::addGroup(QMenu &menu, int first)
{
    QMenu *group = menu.addMenu(m_groups[first]);
    group->setToolTipsVisible(true);
    int item = first;
    for (; item < count() && item < m_groups.size() && m_groups[item] == m_groups[first]; ++item) {
        QAction *action = group->addAction(itemText(item));
        action->setToolTip(itemData(item, Qt::ToolTipRole).toString());
        action->setCheckable(true);
        action->setChecked(item == currentIndex());
        connect(action, &QAction::triggered, this, [this, item] { setCurrentIndex(item); });
    }
    return item;
}

}
