#include "app/ui/settings/appearance.h"

#include "app/ui/actions/command.h"
#include "app/ui/actions/view_commands.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"

#include <QActionGroup>
#include <QApplication>
#include <QMainWindow>
#include <QSettings>

namespace app {

namespace {

constexpr const char *schemeKey = "window/scheme";
constexpr const char *motionKey = "window/lessMotion";

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

Scheme storedScheme()
{
    const QString name = QSettings().value(schemeKey).toString();
    for (const Scheme scheme : {Scheme::dark, Scheme::highContrast}) {
        if (name == nameOf(scheme))
            return scheme;
    }
    return Scheme::light;
}

Appearance::Appearance(QMainWindow &window, SceneBar &bar, SceneView &scene, const ViewCommands &commands,
                       Theme &theme)
    : QObject(&window), m_window(window), m_scene(scene), m_theme(theme)
{
    connect(&theme, &Theme::changed, this, [&theme] { theme.apply(*qApp); });
    auto *schemes = new QActionGroup(this); // none of them: light
    schemes->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    addScheme(*schemes, *commands.dark, Scheme::dark);
    addScheme(*schemes, *commands.highContrast, Scheme::highContrast);
    connect(commands.lessMotion, &QAction::toggled, this, &Appearance::setLessMotion);
    commands.lessMotion->setChecked(QSettings().value(motionKey).toBool());
    rememberShown(bar);
    bar.follow(QStringLiteral("unitCircle"), *commands.unitCircle);
    connect(&scene, &SceneView::contentChanged, this,
            [this, &commands] { followAngle(*commands.unitCircle); });
    followAngle(*commands.unitCircle);
}

void Appearance::followAngle(Command &unitCircle) const
{
    const SceneContent &shown = m_scene.shown();
    const bool hasAngle = shown.points() > 0 && shown.view().angle;
    const QString obstacle = hasAngle ? QString() : tr("This step shows no angle.");
    if (obstacle != unitCircle.obstacle())
        unitCircle.setObstacle(obstacle);
}

void Appearance::addScheme(QActionGroup &group, Command &command, Scheme scheme)
{
    command.setChecked(m_theme.scheme() == scheme);
    group.addAction(&command);
    connect(&command, &QAction::triggered, this, [this, scheme](bool isOn) {
        m_theme.setScheme(isOn ? scheme : Scheme::light);
        QSettings().setValue(schemeKey, nameOf(m_theme.scheme()));
    });
}

void Appearance::setLessMotion(bool isLess)
{
    m_window.setAnimated(!isLess);
    for (const Qt::UIEffect effect : {Qt::UI_AnimateMenu, Qt::UI_FadeMenu, Qt::UI_AnimateCombo,
                                      Qt::UI_AnimateTooltip, Qt::UI_FadeTooltip, Qt::UI_AnimateToolBox})
        QApplication::setEffectEnabled(effect, !isLess);
    Extras extras = m_scene.extras();
    extras.still = isLess;
    m_scene.setExtras(extras);
    QSettings().setValue(motionKey, isLess);
}

void Appearance::rememberShown(SceneBar &bar)
{
    const QString key = "show/";
    for (const QString &id : bar.choices()) {
        if (const QVariant stored = QSettings().value(key + id); stored.isValid())
            bar.choose(id, stored.toBool());
    }
    connect(&bar, &SceneBar::chosen, this,
            [key](const QString &id, bool isOn) { QSettings().setValue(key + id, isOn); });
}

}
