#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/input_queries.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/api/creature.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "view.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;

namespace walking_gait {

namespace {

/// Returns how far right of the body the last drag moved foot 0, in px. Minus infinity if it moved another
/// body or is not finished.
double pulledPastBody(const Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run, "foot0");
    double farthest = -std::numeric_limits<double>::infinity();
    for (const PointerSample &sample : drag ? drag->path : std::vector<PointerSample>())
        farthest = std::max(farthest, sample.position.x - positionOf(run, "body").x);
    return farthest;
}

Condition footReleased()
{
    return {[](const Timeline &run) {
        const std::optional<DragGesture> drag = lastReleased(run);
        return drag && drag->body.starts_with("foot");
    }};
}

Condition holdingFoot()
{
    return {[](const Timeline &run) { return heldBody(run).starts_with("foot"); }};
}

/// Returns the number of frames since the last grab. 0 without one.
double framesSinceGrab(const Timeline &run)
{
    const std::vector<DragGesture> all = dragGestures(run);
    return all.empty() ? 0.0 : static_cast<double>(run.cursor().frame - all.back().grabFrame);
}

/// Returns how far the last drag went to one side, in px.
double sidewaysDragDistance(const Timeline &run)
{
    const std::vector<DragGesture> all = dragGestures(run);
    double farthest = 0.0;
    for (const PointerSample &sample : all.empty() ? std::vector<PointerSample>() : all.back().path)
        farthest = std::max(farthest, std::abs(sample.position.x - grabPosition(run, all.back()).x));
    return farthest;
}

/// Returns whether `body` is dragged anywhere in the script.
bool wasDragged(const Timeline &run, const std::string &body)
{
    const std::vector<sim::Event> &input = run.script().input;
    return std::any_of(input.begin(), input.end(), [&](const sim::Event &event) {
        const auto *grab = std::get_if<sim::Grab>(&event.what);
        return grab && grab->body == body;
    });
}

/// Returns the distance of foot 0 from the centre of the circle on which its target moves, in px.
double footDistance(const Timeline &run)
{
    const sim::Vec2 centre = positionOf(run, "body") + sim::Vec2{0.0, run.values()["drop"]};
    return sim::length(positionOf(run, "foot0") - centre);
}

Check dragBody100()
{
    return {
        .id = "carry_body",
        .conditions = {lastGrabbed("body"), draggedAtLeast(100.0)},
    };
}

/// Returns whether any foot is planted.
bool hasPlantedFoot(const Timeline &run)
{
    const sim::Scene &scene = run.track().interval().scene;
    for (int i = 0; i < run.state().pointCount(); ++i) {
        const bool foot = !isBody(scene.names[static_cast<std::size_t>(i)]);
        if (foot && isPlanted(scene, run.state(), run.values(), i))
            return true;
    }
    return false;
}

/// Returns whether a planted foot moves up at 1 px/frame or more: it has just bounced.
bool justBounced(const Timeline &run)
{
    const sim::State &state = run.state();
    for (int i = 0; i + 1 < state.pointCount(); ++i) {
        if (isPlanted(run.track().interval().scene, state, run.values(), i) && state.velocity(i, 1) <= -1.0)
            return true;
    }
    return false;
}

/// Returns whether a dynamic point touches a side wall.
bool touchesWall(const Timeline &run)
{
    const sim::State &state = run.state();
    const Eigen::ArrayXd halfWidth = halfWidths(run.track().interval().scene);
    for (int i = 0; i < state.pointCount(); ++i) {
        const bool right = state.position(i, 0) + halfWidth[i] >= run.values()["right"];
        const bool left = state.position(i, 0) - halfWidth[i] <= run.values()["left"];
        if (state.isDynamic(i) && (left || right))
            return true;
    }
    return false;
}

bool wasKeyPressed(const Timeline &run, bool sim::Keys::*key)
{
    return hasApplied<sim::Key>(run, [&](const sim::Key &event) { return event.key == key && event.down; });
}

bool wasPointerPressed(const Timeline &run)
{
    return hasApplied<sim::Pointer>(run, [](const sim::Pointer &pointer) { return pointer.down; });
}

double clockSpeedOf(const Timeline &run)
{
    return run.state().gaitSpeed[0];
}

/// Returns whether the clock stood still ten frames ago. If it did not, its speed may only be passing through
/// 0 now.
bool stoodStill(const Timeline &run)
{
    constexpr std::int64_t frames = 10;
    return run.cursor().frame >= frames &&
           std::abs(run.track().stateAt(run.cursor().frame - frames).gaitSpeed[0]) <= 0.005;
}

/// Returns the distance of the nearest other body from the body `name`, in px.
double nearestBody(const Timeline &run, const std::string &name)
{
    double nearest = INFINITY;
    for (const std::string &other : run.track().interval().scene.names) {
        if (isBody(other) && other != name)
            nearest = std::min(nearest, distance(run, name, other));
    }
    return nearest;
}

/// Returns how far left of its start the creature is, in px. 0 if it is on the right.
double walkedLeft(const Timeline &run)
{
    const sim::Scene &scene = run.track().interval().scene;
    return std::max(0.0, scene.start.positionOf(scene.find("body")).x - positionOf(run, "body").x);
}

Condition walkedLeft100()
{
    return atLeast(100.0, walkedLeft, "walked", 0);
}

/// Returns the height to which the last finished drag lifted its body, in px.
double liftHeight(const Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run);
    double height = 0.0;
    for (const PointerSample &sample : drag ? drag->path : std::vector<PointerSample>())
        height = std::max(height, grabPosition(run, *drag).y - sample.position.y);
    return height;
}

Condition inTheAir()
{
    return {[](const Timeline &run) { return !hasPlantedFoot(run); }, "in_the_air"};
}

Condition touchingWall(const QString &sentence)
{
    return {touchesWall, sentence};
}

/// Returns the distance of the nearest other body from the dragged body, in px.
double nearestToDraggedBody(const Timeline &run)
{
    return nearestBody(run, heldBody(run));
}

Condition closerThanDistance(std::function<double(const Timeline &)> nearest, const QString &sentence)
{
    return {[nearest](const Timeline &run) { return nearest(run) < run.values()["distance"]; }, sentence,
            nearest, 0};
}

}

std::vector<Check> bonesChecks()
{
    return {
        {
            .id = "past_body",
            .conditions =
                {
                    released("foot0"),
                    atLeast(20.0, pulledPastBody, "past_body", 0),
                    allStill(),
                },
        },
        dragBody100(),
        {
            .id = "inside_frame",
            .conditions = {insideFrame(), onlyPulled()},
        },
    };
}

std::vector<Check> legsChecks()
{
    return {
        {
            .id = "long_legs",
            .conditions = {parameterSetTo("leg", 100.0), allStill()},
        },
        {
            .id = "pull_foot",
            .conditions = {footReleased(), draggedAtLeast(75.0)},
        },
    };
}

std::vector<Check> feetBelowChecks()
{
    return {
        {
            .id = "no_drop",
            .conditions = {parameterSetTo("drop", 0.0), allStill()},
        },
        {
            .id = "above",
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["drop"] < 0.0; }},
                    allStill(),
                },
        },
        dragBody100(),
    };
}

std::vector<Check> curvedLegsChecks()
{
    return {
        {
            .id = "straight",
            .conditions = [](const Timeline &run) { return isSetTo(run, "curve", 0.0); },
        },
        {
            .id = "compare",
            .conditions =
                {
                    comparisonDiffers("curve"),
                    {[](const Timeline &run) { return wasDragged(run, "body"); }, "carried"},
                    playedSinceFork(),
                },
        },
        {
            .id = "negative",
            .conditions = [](const Timeline &run) { return run.values()["curve"] < 0.0; },
        },
    };
}

std::vector<Check> swingChecks()
{
    return {
        {
            .id = "backwards",
            .conditions = {parameterSetTo("speed", -0.05), unchangedFor("speed", 60)},
        },
        {
            .id = "resonance",
            .conditions =
                {
                    {[](const Timeline &run) { return !isSetTo(run, "speed", 0.05); }},
                    idleFor(120),
                    atLeast(150.0, footDistance, "far", 0),
                },
        },
        {
            .id = "walk_by_hand",
            .conditions =
                {
                    lastGrabbed("body"),
                    atLeast(100.0, sidewaysDragDistance, "sideways", 0),
                },
        },
    };
}

std::vector<Check> bodyPulledChecks()
{
    return {
        {
            .id = "pull_foot",
            .conditions = {footReleased(), draggedAtLeast(75.0)},
        },
        {
            .id = "throw",
            .conditions = {parameterSetTo("damp", 1.0), releasedSinceSet("damp"), thrownAtLeast(),
                           idleFor(100)},
        },
        {
            .id = "hold_foot",
            .conditions =
                {
                    holdingFoot(),
                    atLeast(60.0, framesSinceGrab, "frames", 0),
                },
        },
    };
}

std::vector<Check> groundChecks()
{
    return {
        {
            .id = "walk_left",
            .conditions = {parameterSetTo("speed", -0.05), walkedLeft100()},
        },
        {
            .id = "ice",
            .conditions = {parameterSetTo("traction", 1.0), unchangedFor("traction", 150)},
        },
        {
            .id = "bounce",
            .conditions =
                {
                    parameterSetTo("bounce", 0.8),
                    {justBounced, "bounces"},
                },
            .onlyWhilePaused = true,
        },
        {
            .id = "drop",
            .conditions =
                {
                    released("body"),
                    atLeast(60.0, liftHeight, "lifted", 0),
                    idleFor(60),
                    {hasPlantedFoot, "standing"},
                },
        },
    };
}

std::vector<Check> moreFeetChecks()
{
    return {
        {
            .id = "twelve_feet",
            .conditions = {parameterSetTo("feet", 12.0), parameterSetTo("spread", 360.0, "spread"),
                           unchangedFor("feet", 200), unchangedFor("spread", 200)},
        },
        {
            .id = "together",
            .conditions = {parameterSetTo("spread", 0.0), unchangedFor("spread", 200)},
        },
        {
            .id = "in_the_air",
            .conditions =
                {
                    parameterSetTo("speed", 0.3),
                    parameterSetTo("spread", 360.0, "spread"),
                    parameterSetTo("feet", 5.0, "feet"),
                    unchangedFor("speed", 60),
                    inTheAir(),
                },
            .onlyWhilePaused = true,
        },
    };
}

std::vector<Check> steeringChecks()
{
    return {
        {
            .id = "left_key",
            .conditions =
                {
                    {[](const Timeline &run) { return wasKeyPressed(run, &sim::Keys::left); }},
                    {[](const Timeline &run) { return clockSpeedOf(run) < 0.0; }, "backwards", clockSpeedOf,
                     3},
                    walkedLeft100(),
                },
        },
        {
            .id = "fast",
            .conditions =
                {
                    {[](const Timeline &run) { return wasPointerPressed(run) && run.values()["top"] > 0.0; }},
                    {[](const Timeline &run) { return run.state().input.pointerDown; }, "pointer"},
                    {[](const Timeline &run) { return std::abs(clockSpeedOf(run)) >= run.values()["top"]; },
                     "clock", clockSpeedOf, 3},
                },
        },
        {
            .id = "stand",
            .conditions =
                {
                    {[](const Timeline &run) {
                        return wasPointerPressed(run) || wasKeyPressed(run, &sim::Keys::left) ||
                               wasKeyPressed(run, &sim::Keys::right);
                    }},
                    {[](const Timeline &run) { return std::abs(clockSpeedOf(run)) <= 0.005; }, "clock",
                     clockSpeedOf, 3},
                    {stoodStill, "stands"},
                },
        },
    };
}

std::vector<Check> wallsChecks()
{
    return {
        {
            .id = "walk_on",
            .conditions =
                {
                    parameterSetTo("at_wall", 1.0),
                    unchangedFor("at_wall", 200),
                    touchingWall("wall"),
                },
        },
        {
            .id = "turn",
            .conditions =
                {
                    {[](const Timeline &run) {
                        return run.values()["right"] - run.values()["left"] <= 150.0;
                    }},
                    parameterSetTo("at_wall", 0.0, "turn"),
                    {[](const Timeline &run) { return clockSpeedOf(run) < 0.0; }, "turned"},
                },
        },
        {
            .id = "throw",
            .conditions =
                {
                    released(),
                    thrownAtLeast(),
                    {[](const Timeline &run) { return idleFrames(run) <= 40 && touchesWall(run); },
                     "in_time"},
                },
        },
    };
}

std::vector<Check> companyChecks()
{
    return {
        {
            .id = "drag",
            .conditions =
                {
                    {[](const Timeline &run) { return isBody(heldBody(run)); }},
                    draggedAtLeast(40.0),
                    closerThanDistance(nearestToDraggedBody, "near"),
                },
        },
        {
            .id = "one_sided",
            .conditions =
                {
                    parameterSetTo("felt_by", 1.0),
                    closerThanDistance([](const Timeline &run) { return nearestBody(run, "creature0.body"); },
                                       "touching"),
                },
        },
        {
            .id = "crowd",
            .conditions = {parameterSetTo("creatures", 5.0), unchangedFor("creatures", 300)},
        },
    };
}

}
