#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "scenes.h"
#include "sim/run/timeline.h"

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
    return {flewOffStage, "off_stage"};
}

Condition dampingIs(double value)
{
    return parameterSetTo("damp", value, "damping");
}

}

std::vector<Check> mutualChecks()
{
    const Condition springAtThreeTenths = parameterSetTo("k", 0.3, "k");
    return {
        {
            .id = "foot_moved",
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) { return hasMoved(run, foot) && !hasMoved(run, body); },
                     "foot_moved"},
                },
        },
        {
            .id = "fly_away",
            .conditions =
                {
                    springAtThreeTenths,
                    dampingIs(0.9),
                    runsMethod("published", "method"),
                    idleFor(60),
                    flewOff(),
                },
        },
        {
            .id = "calm_down",
            .conditions = {dampingIs(0.85), springAtThreeTenths, allStill()},
        },
        {
            .id = "euler",
            .conditions =
                {
                    runsMethod("semi_implicit_euler"),
                    springAtThreeTenths,
                    dampingIs(0.9),
                    idleFor(100),
                    {[](const Timeline &run) { return sim::length(momentum(run)) < 0.01; }, "momentum"},
                },
        },
    };
}

std::vector<Check> legLineChecks()
{
    return {
        {
            .id = "stretch",
            .conditions =
                {
                    holdingAnEnd(),
                    atLeast(
                        100.0, [](const Timeline &run) { return distance(run, "foot", "body"); }, "long", 0),
                },
        },
        {
            .id = "squeeze",
            .conditions =
                {
                    {[](const Timeline &run) { return !dragGestures(run).empty(); }},
                    {[](const Timeline &run) { return lengthAtRelease(run) < 30.0; }, "short",
                     lengthAtRelease, 0},
                    {[](const Timeline &run) { return lastReleased(run).has_value(); }, "let_go"},
                },
        },
        {
            .id = "radius",
            .conditions =
                {
                    parameterSetTo("radius", 100.0),
                    allStill(),
                    {[](const Timeline &run) {
                         return std::abs(distance(run, "foot", "body") - 100.0) < 0.5;
                     },
                     "long"},
                },
        },
        {
            .id = "compare",
            .conditions = {comparisonDiffers("k"), playedSinceFork()},
        },
    };
}

}
