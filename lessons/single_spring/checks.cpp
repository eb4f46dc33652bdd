#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/base/direction.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace lessons;
using sim::Timeline;

namespace single_spring {

namespace {

sim::Vec2 centreOf(const Timeline &run)
{
    return {run.values()["centre_x"], run.values()["centre_y"]};
}

double footToCentre(const Timeline &run)
{
    return sim::length(positionOf(run, "foot") - centreOf(run));
}

/// Returns the pointer's position at the release of the foot, in px. NaN if the last drag did not release it.
sim::Vec2 releasePosition(const Timeline &run)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const std::optional<DragGesture> drag = lastReleased(run, "foot");
    return drag && !drag->path.empty() ? drag->path.back().position : sim::Vec2{none, none};
}

/// Returns the speed at the release of the foot, in px/frame. 0 if the last drag did not release it.
double releaseSpeed(const Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run, "foot");
    return drag ? sim::length(drag->releaseVelocity()) : 0.0;
}

/// There has been no input for `frames` frames, and damping has not been set for as long.
Condition idleSinceDampingSet(std::int64_t frames, const QString &sentence)
{
    return atLeast(
        static_cast<double>(frames),
        [](const Timeline &run) {
            return static_cast<double>(std::min(idleFrames(run), framesSinceSet(run, "damp")));
        },
        sentence, 0);
}

Condition isMoving()
{
    return {[](const Timeline &run) { return run.cursor().phase == 0 && !isStill(run); }, "moving"};
}

Condition restsAtDistance(double length, const QString &sentence)
{
    return {[length](const Timeline &run) {
                return isStill(run) && std::abs(distance(run, "foot", "body") - length) < 0.5;
            },
            sentence};
}

/// Returns the angle between the line from body to foot and straight down, in degrees.
double angleFromBelow(const Timeline &run)
{
    const sim::Vec2 from = positionOf(run, "foot") - positionOf(run, "body");
    const double difference = sim::publishedDirection(from).angle - std::numbers::pi / 2;
    return std::abs(difference) * 180.0 / std::numbers::pi;
}

/// Returns whether the foot is within 2 px of its position five frames ago.
bool isHeldStill(const Timeline &run)
{
    constexpr std::int64_t frames = 5;
    if (run.cursor().frame < frames)
        return false;
    const sim::State before = run.track().stateAt(run.cursor().frame - frames);
    const int foot = run.track().interval().scene.find("foot");
    return sim::length(before.positionOf(foot) - run.state().positionOf(foot)) <= 2.0;
}

double footLeftOfBody(const Timeline &run)
{
    return positionOf(run, "body").x - positionOf(run, "foot").x;
}

}

std::vector<Check> dragChecks()
{
    return {
        {
            .id = "lay_down",
            .conditions =
                {
                    released("foot"),
                    atMost(1.0, releaseSpeed, "slow"),
                    allStill(),
                    atMost(15.0, footToCentre, "near"),
                },
        },
        {
            .id = "throw",
            .conditions = {released("foot"), thrownAtLeast(), allStill()},
        },
        {
            .id = "no_damping",
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    releasedSinceSet("damp", "foot"),
                    thrownAtLeast(),
                    isMoving(),
                    idleSinceDampingSet(60, "frames"),
                },
        },
    };
}

std::vector<Check> fixedCentreChecks()
{
    return {
        {
            .id = "pull_out",
            .conditions =
                {
                    released("foot"),
                    atLeast(
                        100.0,
                        [](const Timeline &run) { return sim::length(releasePosition(run) - centreOf(run)); },
                        "far", 0),
                    allStill(),
                },
        },
        {
            .id = "inside_frame",
            .conditions = {insideFrame(), onlyPulled()},
        },
        {
            .id = "no_damping",
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    releasedSinceSet("damp", "foot"),
                    isMoving(),
                    idleSinceDampingSet(100, "frames"),
                },
        },
        {
            .id = "compare",
            .conditions = {comparisonDiffers("damp"), playedSinceFork()},
        },
    };
}

std::vector<Check> movingBodyChecks()
{
    return {
        {
            .id = "carry_body",
            .conditions =
                {
                    lastGrabbed("body"),
                    draggedAtLeast(100.0),
                    restsAtDistance(0.0, "on_body"),
                },
        },
        {
            .id = "soft_spring",
            .conditions =
                {
                    parameterSetTo("k", 0.02),
                    holding("body"),
                    draggedAtLeast(100.0),
                    atLeast(
                        150.0, [](const Timeline &run) { return distance(run, "foot", "body"); }, "behind",
                        0),
                },
        },
        {
            .id = "inside_frame",
            .conditions = {released("foot"), thrownAtLeast(), insideFrame(), onlyPulled()},
        },
    };
}

std::vector<Check> offsetChecks()
{
    return {
        {
            .id = "from_left",
            .conditions =
                {
                    released("foot"),
                    {[](const Timeline &run) { return releasePosition(run).x < positionOf(run, "body").x; },
                     "left"},
                    allStill(),
                },
        },
        {
            .id = "negative",
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["offset"] < 0.0; }},
                    atMost(
                        -10.0, [](const Timeline &run) { return run.values()["offset"]; }, "offset", 0),
                    {[](const Timeline &run) {
                         return isStill(run) &&
                                std::abs(distance(run, "foot", "body") + run.values()["offset"]) < 0.5;
                     },
                     "on_cross"},
                },
        },
        {
            .id = "carry_body",
            .conditions = {lastGrabbed("body"), draggedAtLeast(100.0)},
        },
    };
}

std::vector<Check> radialChecks()
{
    return {
        {
            .id = "rest_on_left",
            .conditions =
                {
                    released("foot"),
                    allStill(),
                    {[](const Timeline &run) { return footLeftOfBody(run) >= 20.0; }, "left"},
                },
        },
        {
            .id = "straight_below",
            .conditions =
                {
                    holding("foot"),
                    atMost(5.0, angleFromBelow, "below", 0),
                    {isHeldStill, "held_still"},
                },
        },
        {
            .id = "radius",
            .conditions =
                {
                    parameterSetTo("radius", 120.0),
                    restsAtDistance(120.0, "on_ring"),
                },
        },
        {
            .id = "inside_frame",
            .conditions = {insideFrame(), onlyPulled()},
        },
    };
}

}
