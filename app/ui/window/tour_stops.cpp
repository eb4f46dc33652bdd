#include "app/ui/window/tour_stops.h"

#include "app/ui/actions/command.h"
#include "app/ui/actions/run_commands.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/scene_column.h"

namespace app {

std::vector<TourStop> tourStops(const QWidget &window, const SceneColumn &centre, const LearnPanel &learn,
                                const QWidget &code, const ParameterPanel &parameters,
                                const RunCommands &commands)
{
    const auto whole = [&window](const QWidget &widget) {
        return [&window, &widget] { return QRect(widget.mapTo(&window, QPoint()), widget.size()); };
    };
    const QWidget &timeline = centre.timeline();
    const auto upperHalf = [&window, &timeline] {
        return QRect(timeline.mapTo(&window, QPoint()), QSize(timeline.width(), timeline.height() / 2));
    };
    const auto lowerHalf = [upperHalf] { return upperHalf().translated(0, upperHalf().height()); };
    const auto keys = [](const Command *command) { return keyText(command->shortcut()); };
    const QWidget *tries = learn.findChild<QWidget *>("tries");
    return {
        {Tour::tr("The picture"),
         Tour::tr("This is the scene of the lesson. Drag anything in it. Let go while moving to throw it."),
         whole(centre.scene())},
        {Tour::tr("Play and stop"),
         Tour::tr("**%1** plays and stops the run. **%2** goes one frame forward, **%3** one frame back.")
             .arg(keys(commands.play), keys(commands.frameForward), keys(commands.frameBack)),
         whole(centre.transport())},
        {Tour::tr("The whole run is kept"),
         Tour::tr("Drag here to go back in time. Change something there, and the old run stays as a ghost."),
         upperHalf},
        {Tour::tr("Inside a frame"),
         Tour::tr("**%1** runs one line of the code, and **%2** takes it back. On the code's page **Engine** "
                  "they go from phase to phase: springs pull, damping slows things down, things move.")
             .arg(keys(commands.phaseForward), keys(commands.phaseBack)),
         lowerHalf},
        {Tour::tr("The code that runs"),
         Tour::tr("These lines compute the scene. Beside them are the current values. Change a line, and the "
                  "picture "
                  "follows."),
         whole(code)},
        {Tour::tr("Numbers to change"),
         Tour::tr("Move a slider, or type any number. The arrow beside it resets the number."),
         whole(parameters)},
        {Tour::tr("Try this"),
         Tour::tr("Springstep ticks each task when it sees you do it. Click a lamp for a hint, or a dotted "
                  "word for its meaning."),
         whole(*tries)},
    };
}

}
