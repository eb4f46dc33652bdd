#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/two_body/text.h"
#include "scenes.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace two_body {

namespace {

/// Returns the length of the leg just before the last drag released it, in px. Without a finished drag, it is
/// the current length.
double lengthAtRelease(const Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run);
    if (!drag)
        return distance(run, "foot", "body");
    const sim::State before = run.track().stateAt(std::max<std::int64_t>(0, *drag->releaseFrame - 1));
    return sim::length(before.positionOf(foot) - before.positionOf(body));
}

Condition holdingAnEnd()
{
    return {[](const Timeline &run) { return !heldBody(run).empty(); }};
}

Condition flewOff()
{
    return {flewOffStage, Text::tr("let time run (**Space**) until the pair has left the stage.")};
}

Condition dampingIs(double value)
{
    return parameterSetTo("damp", value,
                          value == 0.9 ? Text::tr("set **damping** to 0.9.")
                                       : Text::tr("set **damping** to 0.85."));
}

}

std::vector<Try> mutualTries()
{
    const Condition springAtThreeTenths = parameterSetTo("k", 0.3, Text::tr("set **k** to 0.3."));
    return {
        {
            .text = Text::tr(
                "Stop inside a frame when the foot has moved and the body has not. What does the body see?"),
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) { return hasMoved(run, foot) && !hasMoved(run, body); },
                     Text::tr("press **Shift+→** until the foot has moved and the body has not.")},
                },
            .hint = Text::tr(
                "Stop, and press **Shift+→** until the strip under the timeline marks the move of the "
                "foot. The move of the body is still to come."),
            .answer = Text::tr("The foot where it is now. So the body is not pulled back as hard as the foot "
                               "was pulled."),
        },
        {
            .text = Text::tr("Set **k** to 0.3 and hands off: the pair flies away by itself."),
            .conditions =
                {
                    springAtThreeTenths,
                    dampingIs(0.9),
                    runsMethod("published", Text::tr("choose the method **Published**.")),
                    idleFor(60),
                    flewOff(),
                },
            .hint = Text::tr("Type 0.3 into the field beside **k**, press **Space**, and touch nothing."),
        },
        {
            .text = Text::tr("Keep k at 0.3, set **damping** to 0.85, and wait until the pair is still."),
            .conditions = {dampingIs(0.85), springAtThreeTenths, allStill()},
            .hint =
                Text::tr("Type 0.3 beside **k** and 0.85 beside **Damping**. Then press **Space** and wait."),
        },
        {
            .text = Text::tr(
                "With k at 0.3 and damping at 0.9, choose the method **Semi-implicit Euler** and watch 100 "
                "frames, hands off."),
            .conditions =
                {
                    runsMethod("semi_implicit_euler"),
                    springAtThreeTenths,
                    dampingIs(0.9),
                    idleFor(100),
                    {[](const Timeline &run) { return sim::length(momentum(run)) < 0.01; },
                     Text::tr("press **Home** to begin again: your hand has left the pair a momentum.")},
                },
            .hint = Text::tr(
                "Press **Home**. Type 0.3 beside **k** and 0.9 beside **Damping**. Above the picture, choose "
                "**Semi-implicit Euler** as method. Press **Space** and wait four seconds."),
        },
    };
}

std::vector<Try> legLineTries()
{
    return {
        {
            .text = Text::tr("Hold one end and pull so fast that the leg stretches to 100 px or more."),
            .conditions =
                {
                    holdingAnEnd(),
                    atLeast(
                        100.0, [](const Timeline &run) { return distance(run, "foot", "body"); },
                        Text::tr("pull faster. The leg is %1 px long."), 0),
                },
            .hint =
                Text::tr("Press **Space**, take the foot, and pull it quickly into a corner. Do not let go "
                         "yet."),
        },
        {
            .text = Text::tr("Hold one end and squeeze the leg to under 30 px. Then let go."),
            .conditions =
                {
                    {[](const Timeline &run) { return !dragGestures(run).empty(); }},
                    {[](const Timeline &run) { return lengthAtRelease(run) < 30.0; },
                     Text::tr("squeeze the leg to under 30 px and let go there. It was %1 px long."),
                     lengthAtRelease, 0},
                    {[](const Timeline &run) { return lastReleased(run).has_value(); },
                     Text::tr("let go now.")},
                },
            .hint = Text::tr(
                "Press **Space**, take the foot, and push it quickly onto the body. Let go at once."),
        },
        {
            .text = Text::tr("Set **radius** to 100 and wait until the leg is still, 100 px long."),
            .conditions =
                {
                    parameterSetTo("radius", 100.0),
                    allStill(),
                    {[](const Timeline &run) {
                         return std::abs(distance(run, "foot", "body") - 100.0) < 0.5;
                     },
                     Text::tr("pull the two apart, so that the leg becomes 100 px long.")},
                },
            .hint = Text::tr("Type 100 into the field beside **Radius**, press **Space**, and wait."),
        },
        {
            .text = Text::tr("Go back in time, change **k**, and compare with the ghost."),
            .conditions = {comparisonDiffers("k"), playedSinceFork()},
            .hint =
                Text::tr("Play some seconds, drag the timeline back to where both still move, type another "
                         "**k**, and play "
                         "on for a second."),
        },
    };
}

}
