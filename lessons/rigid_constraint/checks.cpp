#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/input_queries.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/rigid_constraint/text.h"
#include "scenes.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "view.h"

#include <QCoreApplication>

#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace rigid_constraint {

namespace {

/// Returns the distance of the pointer from the start of p0, in px. 0 before the first pointer event.
double pointerDistance(const Timeline &run)
{
    const std::optional<sim::Vec2> pointer = run.state().input.pointer;
    return pointer ? sim::length(*pointer - run.track().interval().scene.start.positionOf(0)) : 0.0;
}

/// There has been a pointer event.
Condition hasPointer()
{
    return {[](const Timeline &run) { return run.state().input.pointer.has_value(); },
            Text::tr("hold the mouse button down in the picture, and lead p0.")};
}

/// The pointer is `distance` px or more from the start of p0.
Condition pointerLedTo(double distance)
{
    return atLeast(distance, pointerDistance,
                   Text::tr("lead p0 %2 px away or more, with the mouse button down. So far: %1 px.")
                       .replace(QStringLiteral("%2"), QString::number(distance)),
                   0);
}

double p0FromPointer(const Timeline &run)
{
    return sim::length(positionOf(run, "p0") - run.state().input.pointer.value_or(sim::Vec2{1e9, 1e9}));
}

double worstStickError(const Timeline &run)
{
    return largestError(run.track().interval().scene, run.state());
}

double worstStickStretch(const Timeline &run)
{
    return largestStretch(run.track().interval().scene, run.state());
}

/// Returns the distance of p1 from its start, in px.
double p1Displacement(const Timeline &run)
{
    const sim::Scene &scene = run.track().interval().scene;
    return sim::length(positionOf(run, "p1") - scene.start.positionOf(scene.find("p1")));
}

/// The error of every stick is `max` px or less, between two frames.
Condition errorAtMost(double max, int decimals)
{
    return {[max](const Timeline &run) { return run.cursor().phase == 0 && worstStickError(run) <= max; },
            Text::tr("keep the pointer still. The largest error is %1 px."), worstStickError, decimals};
}

Condition errorAtLeast(double min)
{
    return atLeast(min, worstStickError, Text::tr("move the pointer faster. The largest error is %1 px."));
}

/// Returns whether p1 has stood still for ten frames while p0 moved at least 20 px.
bool onlyP0Moves(const Timeline &run)
{
    if (run.cursor().frame < 10 || run.cursor().phase > 0)
        return false;
    const sim::State before = run.track().stateAt(run.cursor().frame - 10);
    const bool p1Rests = before.pointCount() > 1 && before.positionOf(1) == run.state().positionOf(1);
    return p1Rests && sim::length(before.positionOf(0) - run.state().positionOf(0)) >= 20.0;
}

bool touchesWall(const Timeline &run)
{
    const Eigen::ArrayXd x = run.state().position.col(0);
    const double reach = headRadius + 1e-6;
    return (x <= run.values()["left"] + reach).any() || (x >= run.values()["right"] - reach).any();
}

Condition hitsWall()
{
    return {touchesWall, Text::tr("throw it so that it hits a side wall.")};
}

}

std::vector<Try> pairTries()
{
    return {
        {
            .text = Text::tr("Lead p0 at least 150 px away. p1 is pulled after it."),
            .conditions =
                {
                    hasPointer(),
                    pointerLedTo(150.0),
                    atLeast(60.0, p1Displacement,
                            Text::tr("let time run (**Space**): p1 has come %1 px of 60 px."), 0),
                },
            .hint = Text::tr("Press **Space**. Hold the mouse button down in the picture and lead p0 into an "
                             "upper corner."),
        },
        {
            .text = Text::tr(
                "Stop inside a frame (**Shift+→**) when the pointer has moved p0 by 20 px or more, and "
                "the stick has not acted."),
            .conditions =
                {
                    hasPointer(),
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::driver;
                     },
                     Text::tr(
                         "press **Shift+→** until the pointer has moved p0, and the stick has not acted.")},
                    atLeast(20.0, worstStickError,
                            Text::tr("put the pointer farther from p0 before that frame. It was %1 px."), 0),
                },
            .hint =
                Text::tr("Stop. Press the mouse button 50 px or more beside p0 and keep it down. Then press "
                         "**Shift+→** once."),
        },
        {
            .text = Text::tr("Set **length** to 0 and lead p0 away, 50 px or more. Where is p1?"),
            .conditions =
                {
                    parameterSetTo("length", 0.0),
                    pointerLedTo(50.0),
                    {[](const Timeline &run) { return distance(run, "p0", "p1") < 0.01; },
                     Text::tr("let time run (**Space**) until the stick is right.")},
                },
            .hint = Text::tr(
                "Type 0 into the field beside **Length**. Press **Space**, hold the mouse button down "
                "and lead p0 away."),
            .answer = Text::tr("In the same place as p0: a stick of 0 px holds two points together."),
        },
    };
}

std::vector<Try> sharedErrorTries()
{
    return {
        {
            .text = Text::tr("With **share** at 1, lead the pointer around p1. p1 does not move at all."),
            .conditions =
                {
                    hasPointer(),
                    parameterSetTo("share", 1.0, Text::tr("set **share** to 1.")),
                    pointerLedTo(50.0),
                    {onlyP0Moves, Text::tr("lead the pointer on, so that p0 comes 20 px or more in ten "
                                           "frames while p1 stands.")},
                },
            .hint =
                Text::tr("Leave **Share** at 1. Press **Space**, hold the mouse button down, and lead the "
                         "pointer round p1 in a wide circle."),
        },
        {
            .text = Text::tr("Set **share** to 0 and lead p0 at least 150 px away. It stays at the pointer."),
            .conditions =
                {
                    parameterSetTo("share", 0.0),
                    pointerLedTo(150.0),
                    {[](const Timeline &run) { return p0FromPointer(run) < 0.01; },
                     Text::tr("let time run (**Space**) until p0 is at the pointer.")},
                },
            .hint = Text::tr(
                "Type 0 into the field beside **Share**. Press **Space**, hold the mouse button down "
                "and lead p0 to the other side of the picture."),
        },
        {
            .text = Text::tr(
                "Set **share** to 0.5, lead p0 100 px away or more, and hold the pointer still until p0 has "
                "come to it."),
            .conditions =
                {
                    parameterSetTo("share", 0.5),
                    pointerLedTo(100.0),
                    {[](const Timeline &run) { return p0FromPointer(run) < 0.5; },
                     Text::tr("hold the pointer still while time runs. p0 is %1 px from it."), p0FromPointer},
                },
            .hint =
                Text::tr("Type 0.5 into the field beside **Share**. Press **Space**, hold the mouse button "
                         "down, move the pointer far away, and keep still."),
        },
    };
}

std::vector<Try> triangleTries()
{
    return {
        {
            .text = Text::tr("Lead p0 away so fast that a stick is wrong by 10 px."),
            .conditions = {hasPointer(), pointerLedTo(100.0), errorAtLeast(10.0)},
            .hint = Text::tr(
                "Press **Space**, hold the mouse button down, and move the pointer quickly across the "
                "picture."),
        },
        {
            .text = Text::tr("Then hold it still until all three sticks are right to 0.01 px."),
            .conditions = {hasPointer(), pointerLedTo(100.0), errorAtMost(0.01, 2)},
            .hint = Text::tr(
                "Keep the mouse button down and the pointer still for some seconds. The largest error "
                "stands above the parameters."),
        },
        {
            .text = Text::tr("Set **length** to 150 and lead p0 off the line, until all three sticks are "
                             "right to 0.01 px."),
            .conditions = {parameterSetTo("length", 150.0), hasPointer(), pointerLedTo(20.0),
                           errorAtMost(0.01, 2)},
            .hint =
                Text::tr("Type 150 into the field beside **Length**. Press **Space**, hold the mouse button "
                         "down, lead p0 to the side, and keep still."),
        },
    };
}

std::vector<Try> listTries()
{
    return {
        {
            .text = Text::tr("Lead p0 at least 150 px away, and wait until every stick is right to 0.1 px."),
            .conditions = {hasPointer(), pointerLedTo(150.0), errorAtMost(0.1, 1)},
            .hint =
                Text::tr("Press **Space**, hold the mouse button down, lead p0 across the picture, and keep "
                         "still."),
        },
        {
            .text = Text::tr("Set **triangles** to 15 and shake p0, until a stick is wrong by 20 px."),
            .conditions = {parameterSetTo("triangles", 15.0), hasPointer(), pointerLedTo(20.0),
                           errorAtLeast(20.0)},
            .hint = Text::tr(
                "Type 15 into the field beside **Triangles**. Press **Space**, hold the mouse button "
                "down, and shake p0 to and fro."),
        },
        {
            .text = Text::tr("Go back in time, change **length**, and compare with the ghost."),
            .conditions = {comparisonDiffers("length"), playedSinceFork()},
            .hint =
                Text::tr("Play and lead p0 for some seconds. Stop, drag the timeline back to the left, type "
                         "another **Length**, and play on for a second."),
        },
    };
}

std::vector<Try> verletTries()
{
    return {
        {
            .text = Text::tr("Throw the box against a wall, at 5 px per frame or more."),
            .conditions = {released(), thrownAtLeast(), hitsWall()},
            .hint = Text::tr(
                "Press **Space**. Take a corner of the box, swing it quickly to one side, and let go "
                "on the way."),
        },
        {
            .text = Text::tr(
                "Set **iterations** to 20, carry the box 50 px or more, drop it, and wait until it lies "
                "still."),
            .conditions =
                {
                    parameterSetTo("iterations", 20.0),
                    releasedSinceSet("iterations"),
                    draggedAtLeast(50.0),
                    allStill(),
                },
            .hint =
                Text::tr("Type 20 into the field beside **Iterations**. Press **Space**, lift the box by a "
                         "corner, let go, and wait."),
        },
        {
            .text = Text::tr("Set **gravity** to 0 and throw it. A second later it still glides."),
            .conditions =
                {
                    parameterSetTo("gravity", 0.0),
                    releasedSinceSet("gravity"),
                    thrownAtLeast(),
                    idleFor(30),
                },
            .hint = Text::tr(
                "Type 0 into the field beside **Gravity**. Press **Space**, throw the box, and watch "
                "it for a second."),
        },
        {
            .text = Text::tr(
                "Stop inside a frame when the sticks have moved points, and the velocity is still the old "
                "one."),
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::stick;
                     },
                     Text::tr("press **Shift+→** until the sticks are the last phase that was done.")},
                },
            .hint =
                Text::tr("Stop, and press **Shift+→** until the strip under the timeline marks the sticks."),
        },
    };
}

std::vector<Try> ragdollTries()
{
    return {
        {
            .text = Text::tr("Lift it by any point, 50 px or more, drop it, and wait until it lies still."),
            .conditions = {released(), draggedAtLeast(50.0), allStill()},
            .hint =
                Text::tr("Press **Space**. Take any joint, lift the figure, let go, and wait until it lies "
                         "still."),
        },
        {
            .text = Text::tr("Throw it at a wall, at 5 px per frame or more."),
            .conditions = {released(), thrownAtLeast(), hitsWall()},
            .hint = Text::tr("Press **Space**, take a joint, swing it quickly to one side, and let go on the "
                             "way."),
        },
        {
            .text = Text::tr("Set **iterations** to 1 and shake it, until a stick is wrong by 25 %."),
            .conditions =
                {
                    parameterSetTo("iterations", 1.0),
                    {[](const Timeline &run) { return !heldBody(run).empty(); },
                     Text::tr("take it with the mouse, and shake it.")},
                    atLeast(25.0, worstStickStretch,
                            Text::tr("shake it harder. The worst stick is wrong by %1 %."), 0),
                },
            .hint = Text::tr(
                "Type 1 into the field beside **Iterations**. Press **Space**, take a joint, and shake "
                "it to and fro."),
        },
        {
            .text = Text::tr(
                "Go back in time to before you threw it, change **iterations**, and compare with the "
                "ghost."),
            .conditions =
                {
                    comparisonDiffers("iterations"),
                    {[](const Timeline &run) { return hasInputFrom<sim::Release>(run, run.forkFrame() + 1); },
                     Text::tr("go back to before you threw it, and change **iterations** there.")},
                    playedSinceFork(),
                },
            .hint = Text::tr(
                "Throw the figure and stop. Drag the timeline back to before the throw, type another "
                "number of **Iterations**, and play on for a second."),
        },
    };
}

}
