#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/input_queries.h"
#include "lessons/api/checks/run_queries.h"
#include "scenes.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "view.h"

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
    return {[](const Timeline &run) { return run.state().input.pointer.has_value(); }, "pointer"};
}

/// The pointer is `distance` px or more from the start of p0.
Condition pointerLedTo(double distance)
{
    return atLeast(distance, pointerDistance, "led", 0);
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

/// Returns how far p0 has moved since the start of the frame, in px.
double p0MoveInFrame(const Timeline &run)
{
    const sim::State before = run.track().stateAt(run.cursor().frame);
    return sim::length(positionOf(run, "p0") - before.positionOf(0));
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
            "small_error", worstStickError, decimals};
}

Condition errorAtLeast(double min)
{
    return atLeast(min, worstStickError, "large_error");
}

/// The error of a stick is `min` px or more, and p0 has moved 50 px in ten frames. At the start the sticks are wrong
/// although nothing moves.
Condition errorByMotion(double min)
{
    const auto isFast = [min](const Timeline &run) {
        const std::int64_t before = run.cursor().frame - 10;
        return before >= 0 && worstStickError(run) >= min &&
               sim::length(run.state().positionOf(0) - run.track().stateAt(before).positionOf(0)) >= 50.0;
    };
    return {isFast, "large_error", worstStickError};
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
    return {touchesWall, "wall"};
}

}

std::vector<Check> pairChecks()
{
    return {
        {
            .id = "lead",
            .conditions =
                {
                    hasPointer(),
                    pointerLedTo(150.0),
                    atLeast(60.0, p1Displacement, "p1_moved", 0),
                },
        },
        {
            .id = "before_stick",
            .conditions =
                {
                    hasPointer(),
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::driver;
                     },
                     "phase"},
                    atLeast(20.0, p0MoveInFrame, "p0_moved", 0),
                },
        },
        {
            .id = "no_length",
            .conditions =
                {
                    parameterSetTo("length", 0.0),
                    pointerLedTo(50.0),
                    {[](const Timeline &run) { return distance(run, "p0", "p1") < 0.01; }, "together"},
                },
        },
    };
}

std::vector<Check> sharedErrorChecks()
{
    return {
        {
            .id = "nail",
            .conditions =
                {
                    hasPointer(),
                    parameterSetTo("share", 1.0, "share"),
                    pointerLedTo(50.0),
                    {onlyP0Moves, "only_p0"},
                },
        },
        {
            .id = "leave",
            .conditions =
                {
                    parameterSetTo("share", 0.0),
                    pointerLedTo(150.0),
                    {[](const Timeline &run) { return p0FromPointer(run) < 0.01; }, "at_pointer"},
                },
        },
        {
            .id = "half",
            .conditions =
                {
                    parameterSetTo("share", 0.5),
                    pointerLedTo(100.0),
                    {[](const Timeline &run) { return p0FromPointer(run) < 0.5; }, "at_pointer",
                     p0FromPointer},
                },
        },
    };
}

std::vector<Check> triangleChecks()
{
    return {
        {
            .id = "fast",
            .conditions = {hasPointer(), pointerLedTo(20.0), errorByMotion(10.0)},
        },
        {
            .id = "still",
            .conditions = {hasPointer(), pointerLedTo(20.0), errorAtMost(0.01, 2)},
        },
        {
            .id = "larger",
            .conditions = {parameterSetTo("length", 150.0), hasPointer(), pointerLedTo(20.0),
                           errorAtMost(0.01, 2)},
        },
    };
}

std::vector<Check> listChecks()
{
    return {
        {
            .id = "lead",
            .conditions = {hasPointer(), pointerLedTo(150.0), errorAtMost(0.1, 1)},
        },
        {
            .id = "shake",
            .conditions = {parameterSetTo("triangles", 15.0), hasPointer(), pointerLedTo(20.0),
                           errorAtLeast(20.0)},
        },
        {
            .id = "compare",
            .conditions = {comparisonDiffers("length"), playedSinceFork()},
        },
    };
}

std::vector<Check> verletChecks()
{
    return {
        {
            .id = "wall",
            .conditions = {released(), thrownAtLeast(), hitsWall()},
        },
        {
            .id = "stiff",
            .conditions =
                {
                    parameterSetTo("iterations", 20.0),
                    releasedSinceSet("iterations"),
                    draggedAtLeast(50.0),
                    allStill(),
                },
        },
        {
            .id = "no_gravity",
            .conditions =
                {
                    parameterSetTo("gravity", 0.0),
                    releasedSinceSet("gravity"),
                    thrownAtLeast(),
                    idleFor(30),
                },
        },
        {
            .id = "after_sticks",
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::stick;
                     },
                     "phase"},
                },
        },
    };
}

std::vector<Check> ragdollChecks()
{
    return {
        {
            .id = "drop",
            .conditions = {released(), draggedAtLeast(50.0), allStill()},
        },
        {
            .id = "wall",
            .conditions = {released(), thrownAtLeast(), hitsWall()},
        },
        {
            .id = "one_iteration",
            .conditions =
                {
                    parameterSetTo("iterations", 1.0),
                    {[](const Timeline &run) { return !heldBody(run).empty(); }, "held"},
                    atLeast(25.0, worstStickStretch, "stretch", 0),
                },
        },
        {
            .id = "compare",
            .conditions =
                {
                    comparisonDiffers("iterations"),
                    {[](const Timeline &run) { return hasInputFrom<sim::Release>(run, run.forkFrame() + 1); },
                     "before_throw"},
                    playedSinceFork(),
                },
        },
    };
}

}
