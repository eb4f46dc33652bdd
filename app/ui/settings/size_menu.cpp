#include "app/ui/settings/size_menu.h"

#include <QActionGroup>
#include <QScreen>
#include <QSettings>

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr const char *sizeKey = "window/size";
constexpr std::array sizes{100, 125, 150, 175, 200}; ///< percent
constexpr QSize leastRoom{800, 500};                 ///< px at 100 % that the scene with its time needs

}

int storedSize()
{
    const int stored = QSettings().value(sizeKey, sizes.front()).toInt();
    return std::find(sizes.begin(), sizes.end(), stored) == sizes.end() ? sizes.front() : stored;
}

bool hasRoomFor(int size, QSize screen)
{
    const QSize room = screen * 100 / size;
    return size == sizes.front() ||
           (room.width() >= leastRoom.width() && room.height() >= leastRoom.height());
}

SizeMenu::SizeMenu(QWidget *parent) : QMenu(tr("Si&ze of text and controls"), parent), m_current(storedSize())
{
    setToolTipsVisible(true);
    auto *group = new QActionGroup(this);
    for (const int size : sizes) {
        QAction *entry = addAction(tr("%1\u2009%").arg(size));
        entry->setCheckable(true);
        entry->setChecked(size == m_current);
        entry->setData(size);
        group->addAction(entry);
        connect(entry, &QAction::triggered, this, [this, size] { choose(size); });
    }
    connect(this, &QMenu::aboutToShow, this, &SizeMenu::follow);
}

void SizeMenu::follow()
{
    // The screen's size is in pixels of the size in use.
    const QSize screen = parentWidget()->screen()->availableSize() * m_current / 100;
    for (QAction *entry : actions()) {
        entry->setEnabled(hasRoomFor(entry->data().toInt(), screen));
        entry->setToolTip(
            entry->isEnabled()
                ? tr("Changes text, buttons and the scene. The window opens again with all its contents")
                : tr("At that size, this screen is too small for the scene and its timeline"));
    }
}

void SizeMenu::choose(int size)
{
    QSettings().setValue(sizeKey, size);
    if (size == m_current)
        emit unchanged();
    else
        emit restartWanted(tr("Springstep will be drawn at %1\u2009% after a restart.").arg(size));
}

}
