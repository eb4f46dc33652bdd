#include "steps.h"

#include "lessons/api/checks/hand.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/api/parameters.h"
#include "scenes.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace two_body {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(TwoBody)
};

Step stepOf(const char *id, const QString &title)
{
    Step step = lessons::stepCalled("two_body", id, title);
    step.parameters = {stiffness(), damping(), radius()};
    return step;
}

/// How long the leg was when the hand let go, in px; as long as it holds, how long it is.
double lengthLetGo(const Timeline &run)
{
    const std::optional<Carry> carry = lastLetGo(run);
    if (!carry)
        return distance(run, "foot", "body");
    const sim::State then = run.track().stateAt(std::max<std::int64_t>(0, *carry->letGo - 1));
    return sim::length(then.at(foot) - then.at(body));
}

Condition holdingAnEnd()
{
    return {[](const Timeline &run) { return !heldBody(run).empty(); }};
}

/// No throw is as fast as this so long after the hand let go.
Condition flewOff()
{
    return {[](const Timeline &run) { return !onStage(middle(run)) && sim::length(momentum(run)) >= 2.0; },
            Text::tr("let time run (**Space**) until the pair has left the stage.")};
}

Condition dampingIs(double value)
{
    return isSet("damp", value,
                 value == 0.9 ? Text::tr("set **damping** to 0.9.") : Text::tr("set **damping** to 0.85."));
}

std::vector<Try> mutualTries()
{
    const Condition springAtThreeTenths = isSet("k", 0.3, Text::tr("set **k** to 0.3."));
    return {
        Try{Text::tr(
                "Stop inside a frame when the foot has moved and the body has not. What does the body see?"),
            {insideAFrame(),
             {[](const Timeline &run) { return hasMoved(run, foot) && !hasMoved(run, body); },
              Text::tr("press **Shift+→** until the foot has moved and the body has not.")}}}
            .answered(Text::tr("The foot where it is now. So the body is not pulled back as hard as the foot "
                               "was pulled.")),
        {Text::tr("Set **k** to 0.3 and hands off: the pair flies away by itself."),
         {springAtThreeTenths, dampingIs(0.9),
          byMethod("published", Text::tr("choose the method **Published**.")), handsOff(60), flewOff()}},
        {Text::tr("Keep k at 0.3, set **damping** to 0.85, and wait until the pair is still."),
         {dampingIs(0.85), springAtThreeTenths, allStill()}},
        {Text::tr("With k at 0.3 and damping at 0.9, choose the method **Semi-implicit Euler** and watch 100 "
                  "frames, hands off."),
         {byMethod("semi_implicit_euler"),
          springAtThreeTenths,
          dampingIs(0.9),
          handsOff(100),
          {[](const Timeline &run) { return sim::length(momentum(run)) < 0.01; },
           Text::tr("press **Home** to begin again: your hand has left the pair a momentum.")}}},
    };
}

std::vector<Try> legLineTries()
{
    return {
        {Text::tr("Hold one end and pull so fast that the leg stretches to 100 px or more."),
         {holdingAnEnd(), atLeast(
                              100.0, [](const Timeline &run) { return distance(run, "foot", "body"); },
                              Text::tr("pull faster. The leg is %1 px long."), 0)}},
        {Text::tr("Hold one end and squeeze the leg to under 30 px. Then let go."),
         {{[](const Timeline &run) { return !carries(run).empty(); }},
          {[](const Timeline &run) { return lengthLetGo(run) < 30.0; },
           Text::tr("squeeze the leg to under 30 px and let go there. It was %1 px long."), lengthLetGo, 0},
          {[](const Timeline &run) { return lastLetGo(run).has_value(); }, Text::tr("let go now.")}}},
        {Text::tr("Set **radius** to 100 and wait until the leg is still, 100 px long."),
         {isSet("radius", 100.0),
          allStill(),
          {[](const Timeline &run) { return std::abs(distance(run, "foot", "body") - 100.0) < 0.5; },
           Text::tr("pull the two apart, so that the leg becomes 100 px long.")}}},
        {Text::tr("Go back in time, change **k**, and compare with the ghost."),
         {ghostDiffers("k"), besideGhost()}},
    };
}

}

Step mutualStep()
{
    Step step = stepOf("mutual", Text::tr("Each pulls the other"));
    step.narration =
        Text::tr("Now **both are pulled**: the foot to a place 50 px from the body, and the body to a "
                 "place 50 px from the foot. It is one rule, used twice.\n\n"
                 "The foot moves first, and the body sees it **where it already is**. So the two pulls "
                 "are not quite opposite, and the velocities add up to more than nothing. That sum is "
                 "the **momentum**, and here it comes from nowhere: the pair drifts.\n\n"
                 "With k = 0.3 it flies for ever. Set damping to 0.85 as well, and it calms down: "
                 "damping then takes more than the order of moves gives.\n\n"
                 "The method Semi-implicit Euler moves both **at once**. Their pulls are opposite, and "
                 "the momentum stays 0.");
    step.tries = mutualTries();
    step.scene = mutual::setUp;
    step.look = [](const sim::Scene &scene, const sim::Values &) { return mutual::look(scene); };
    return step;
}

Step legLineStep()
{
    Step step = stepOf("leg_line", Text::tr("A leg"));
    step.narration = Text::tr(
        "A body, a foot, and now a **leg**: a line from one to the other. In the code it is one line, "
        "too.\n\n"
        "It is drawn after each frame, from the two places as they are then, so it always fits. It adds "
        "no pull and costs no phase: **what is drawn cannot change what is computed**.\n\n"
        "But it shows how long the spring is. Where it is longer than **radius**, the spring pulls its two "
        "ends "
        "together; where it is shorter, the spring pushes them apart; and at 50 px it does nothing.");
    step.tries = legLineTries();
    step.scene = leg_line::setUp;
    step.look = [](const sim::Scene &scene, const sim::Values &) { return leg_line::look(scene); };
    return step;
}

}
