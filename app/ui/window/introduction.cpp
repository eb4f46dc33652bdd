#include "app/ui/window/introduction.h"

#include "app/model/session/session.h"
#include "app/ui/actions/commands.h"
#include "app/ui/dock/panel_layout.h"
#include "app/ui/help/tour.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/map/map_page.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/help_pages.h"
#include "app/ui/window/mode_choice.h"
#include "app/ui/window/scene_column.h"

#include <QDockWidget>
#include <QMainWindow>

namespace app {

namespace {

std::vector<TourStop> stopsOf(const TourParts &parts)
{
    const QWidget &window = parts.layout.window;
    const auto whole = [&window](const QWidget &widget) {
        return [&window, &widget] { return QRect(widget.mapTo(&window, QPoint()), widget.size()); };
    };
    const QWidget &timeline = parts.centre.timeline();
    const auto upperHalf = [&window, &timeline] {
        return QRect(timeline.mapTo(&window, QPoint()), QSize(timeline.width(), timeline.height() / 2));
    };
    const auto lowerHalf = [upperHalf] { return upperHalf().translated(0, upperHalf().height()); };
    const RunCommands &run = parts.commands.run;
    const auto keys = [](const Command *command) { return keyText(command->shortcut()); };
    const QWidget *tries = parts.learn.findChild<QWidget *>("tries");
    return {
        {Tour::tr("The picture"),
         Tour::tr("This is the scene of the lesson. Drag anything in it. Let go while moving to throw it."),
         whole(parts.centre.scene())},
        {Tour::tr("Play and stop"),
         Tour::tr("**%1** plays and stops the run. **%2** goes one frame forward, **%3** one frame back.")
             .arg(keys(run.play), keys(run.frameForward), keys(run.frameBack)),
         whole(parts.centre.transport())},
        {Tour::tr("The whole run is kept"),
         Tour::tr("Drag here to go back in time. Change something there, and the old run stays as a ghost."),
         upperHalf},
        {Tour::tr("Inside a frame"),
         Tour::tr("**%1** runs one line of the code, and **%2** takes it back. On the code's page **Engine** "
                  "they go from phase to phase: springs pull, damping slows things down, things move.")
             .arg(keys(run.phaseForward), keys(run.phaseBack)),
         lowerHalf},
        {Tour::tr("The code that runs"),
         Tour::tr("These lines compute the scene. Beside them are the current values. Change a line, and the "
                  "picture "
                  "follows."),
         whole(parts.code)},
        {Tour::tr("Numbers to change"),
         Tour::tr("Move a slider, or type any number. The arrow beside it resets the number."),
         whole(parts.parameters)},
        {Tour::tr("Try this"),
         Tour::tr("Springstep ticks each task when it sees you do it. Click a lamp for a hint, or a dotted "
                  "word for its meaning."),
         whole(*tries)},
    };
}

}

Introduction::Introduction(const TourParts &parts, Session &session, HelpPages &help, const Theme &theme)
    : m_parts(parts), m_help(help), m_theme(theme)
{
    const auto offerMap = [this, &session] {
        m_parts.commands.help.map->setObstacle(
            MapPage::hasConcepts(session.library()) ? QString() : tr("These lessons have no concepts"));
    };
    offerMap();
    session.onChange(ChangeKind::texts, this, offerMap);
}

void Introduction::startTour()
{
    m_parts.mode.choose(WindowMode::learn);
    for (const Panel panel : {Panel::lessons, Panel::code, Panel::parameters})
        m_parts.layout.docks[panel].show();
    m_parts.learn.setForm(LearnPanel::Form::whole);
    if (!m_tour) {
        m_tour = new Tour(stopsOf(m_parts), m_theme, &m_parts.layout.window);
        connect(m_tour, &Tour::ended, &m_parts.centre.scene(), qOverload<>(&QWidget::setFocus));
    }
    m_tour->start();
}

void Introduction::showMap()
{
    // The window can be closed before a timer shows the map.
    if (m_parts.layout.window.isVisible() && m_parts.commands.help.map->isEnabled())
        m_help.showMap();
}

void Introduction::welcome()
{
    startTour();
    connect(m_tour, &Tour::ended, this, &Introduction::showMap, Qt::SingleShotConnection);
}

}
