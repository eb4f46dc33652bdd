// How the window looks: colours, size, motion.

#include "app/ui/window/appearance.h"

#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr const char *schemeKey = "window/scheme";
constexpr const char *sizeKey = "window/size";
constexpr const char *motionKey = "window/lessMotion";
constexpr std::array sizes{100, 125, 150, 175, 200}; ///< percent
constexpr QSize leastRoom{800, 500};                 ///< px at 100 % that the scene with its time needs

const char *nameOf(Scheme scheme)
{
    switch (scheme) {
    case Scheme::dark:
        return "dark";
    case Scheme::highContrast:
        return "contrast";
    case Scheme::light:
        break;
    }
    return "light";
}

}

Scheme keptScheme()
{
    const QString name = QSettings().value(schemeKey).toString();
    for (const Scheme scheme : {Scheme::dark, Scheme::highContrast}) {
        if (name == nameOf(scheme))
            return scheme;
    }
    return Scheme::light;
}

int keptSize()
{
    const int kept = QSettings().value(sizeKey, sizes.front()).toInt();
    return std::find(sizes.begin(), sizes.end(), kept) == sizes.end() ? sizes.front() : kept;
}

bool hasRoomFor(int size, QSize screen)
{
    const QSize room = screen * 100 / size;
    return size == sizes.front() ||
           (room.width() >= leastRoom.width() && room.height() >= leastRoom.height());
}

void MainWindow::makeAppearanceActions()
{
    m_view->addSeparator();
    makeSchemeActions();
    makeSizeActions();
    QAction *still = m_commands->add(tr("Less mo&vement"), {}, KeyGroup::window);
    still->setObjectName("lessMotion");
    still->setToolTip(
        tr("Panels and menus come and go at once, wind is drawn still; only what is computed moves"));
    still->setCheckable(true);
    m_view->addAction(still);
    connect(still, &QAction::toggled, this, &MainWindow::setStill);
    still->setChecked(QSettings().value(motionKey).toBool());
    makeFocusActions();
    rememberChoices();
}

void MainWindow::setStill(bool still)
{
    setAnimated(!still);
    for (const Qt::UIEffect effect : {Qt::UI_AnimateMenu, Qt::UI_FadeMenu, Qt::UI_AnimateCombo,
                                      Qt::UI_AnimateTooltip, Qt::UI_FadeTooltip, Qt::UI_AnimateToolBox})
        QApplication::setEffectEnabled(effect, !still);
    Extras extras = m_scene->extras();
    extras.still = still;
    m_scene->setExtras(extras);
    QSettings().setValue(motionKey, still);
}

void MainWindow::rememberChoices()
{
    const QString key = "show/";
    for (const QString &id : m_sceneBar->choices()) {
        if (const QVariant kept = QSettings().value(key + id); kept.isValid())
            m_sceneBar->choose(id, kept.toBool());
    }
    connect(m_sceneBar, &SceneBar::chosen, this,
            [key](const QString &id, bool on) { QSettings().setValue(key + id, on); });
}

void MainWindow::makeSchemeActions()
{
    auto *schemes = new QActionGroup(this); // none of them: light
    schemes->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    const auto add = [&](const QString &text, const QKeySequence &key, Scheme scheme) {
        QAction *made = m_commands->add(text, {key}, KeyGroup::window);
        made->setObjectName(nameOf(scheme));
        made->setCheckable(true);
        made->setChecked(m_theme.scheme() == scheme);
        schemes->addAction(made);
        m_view->addAction(made);
        connect(made, &QAction::triggered, this, [this, scheme](bool on) {
            m_theme.setScheme(on ? scheme : Scheme::light);
            QSettings().setValue(schemeKey, nameOf(m_theme.scheme()));
        });
    };
    add(tr("&Dark"), QKeySequence("Ctrl+Shift+D"), Scheme::dark);
    add(tr("&High contrast"), QKeySequence("Ctrl+Shift+H"), Scheme::highContrast);
}

void MainWindow::makeSizeActions()
{
    auto *menu = m_view->addMenu(tr("Si&ze of text and controls"));
    auto *group = new QActionGroup(this);
    menu->setToolTipsVisible(true);
    const int drawn = keptSize();
    for (const int size : sizes) {
        QAction *made = menu->addAction(tr("%1\u2009%").arg(size));
        made->setCheckable(true);
        made->setChecked(size == drawn);
        group->addAction(made);
        connect(menu, &QMenu::aboutToShow, made, [this, made, size, drawn] {
            made->setEnabled(hasRoomFor(size, screen()->availableSize() * drawn / 100));
            made->setToolTip(
                made->isEnabled()
                    ? tr("Text, buttons and the picture; the window opens again with all that is in it")
                    : tr("This screen is too small for the scene with its time at that size"));
        });
        connect(made, &QAction::triggered, this, [this, size, drawn] {
            QSettings().setValue(sizeKey, size);
            if (size == drawn)
                m_notice->say({}); // as it is
            else
                startAgainFor(tr("At its next start, Springstep is drawn at %1\u2009%.").arg(size));
        });
    }
}

}
