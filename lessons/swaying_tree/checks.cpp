#include "checks.h"

#include "lessons/api/checks/run_queries.h"
#include "scenes.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "view.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;

namespace swaying_tree {

namespace {

const sim::Scene &sceneOf(const Timeline &run)
{
    return run.track().interval().scene;
}

double currentBend(const Timeline &run)
{
    return largestBend(sceneOf(run), run.state());
}

/// Returns the angle of the trunk from straight up, in degrees.
double trunkAngle(const Timeline &run)
{
    return bendOf(sceneOf(run), run.state(), 0);
}

bool isBlowing(const Timeline &run)
{
    return run.state().input.pointerDown;
}

/// Returns whether the published formula is chosen at the cursor.
bool isPublished(const Timeline &run)
{
    return formulaOf(run.values()) == sim::TreeFormula::published;
}

/// Returns the number of frames since the button was last pressed or released, up to the cursor. -1 before
/// the first pointer event.
std::int64_t framesSinceButton(const Timeline &run)
{
    std::int64_t since = -1;
    bool down = false;
    for (const sim::Event &event : run.script().input) {
        const auto *pointer = std::get_if<sim::Pointer>(&event.what);
        if (event.frame > run.cursor().frame || !pointer)
            continue;
        if (since < 0 || pointer->down != down)
            since = event.frame;
        down = pointer->down;
    }
    return since < 0 ? -1 : run.cursor().frame - since;
}

/// Returns the state just before the last release of the button. Empty while the button is down and before a
/// release, and if the tree has had another number of branches since: their bends cannot be compared with its own.
std::optional<sim::State> stateBeforeRelease(const Timeline &run)
{
    const std::int64_t since = framesSinceButton(run);
    if (since < 0 || isBlowing(run) || run.cursor().frame - since < 1)
        return {};
    sim::State state = run.track().stateAt(run.cursor().frame - since - 1);
    if (state.pointCount() != run.state().pointCount())
        return {};
    return state;
}

/// Returns the largest angle between a branch and the direction to the pointer, in degrees.
double largestAimError(const Timeline &run)
{
    const sim::State &state = run.state();
    const sim::Vec2 pointer = state.input.pointer.value_or(sim::Vec2{});
    double worst = 0.0;
    for (int i = 0; i < state.pointCount(); ++i) {
        const sim::Vec2 toPointer = pointer - state.positionOf(i);
        const double angle = std::atan2(toPointer.y, toPointer.x) * sim::degreesPerRadian;
        worst = std::max(worst, std::abs(std::remainder(state.angle[i] - angle, 360.0)));
    }
    return worst;
}

/// Returns the largest bend just before the last release of the button, in degrees. 0 without one.
double bendBeforeRelease(const Timeline &run)
{
    const std::optional<sim::State> state = stateBeforeRelease(run);
    return state ? largestBend(sceneOf(run), *state) : 0.0;
}

Condition blowing()
{
    return {isBlowing, "blowing"};
}

Condition windReleased()
{
    return {[](const Timeline &run) { return stateBeforeRelease(run).has_value(); }, "let_go"};
}

/// The button has been released since the parameter `id` was set last.
Condition windReleasedSinceSet(const std::string &id)
{
    return {[id](const Timeline &run) {
                return stateBeforeRelease(run) &&
                       run.cursor().frame - framesSinceButton(run) >= lastSetFrame(run, id);
            },
            windReleased().sentence};
}

Condition unchangedButtonFor(std::int64_t frames)
{
    return atLeast(
        static_cast<double>(frames),
        [](const Timeline &run) { return static_cast<double>(framesSinceButton(run)); }, "frames", 0);
}

Condition pointingAtPointer()
{
    return atMost(1.0, largestAimError, "aim", 0);
}

Condition trunkLeans(double min)
{
    return atLeast(
        min, [](const Timeline &run) { return std::abs(trunkAngle(run)); }, "lean", 0);
}

Conditions returned(const Condition &first, const Condition &released)
{
    return {first, released, atLeast(60.0, bendBeforeRelease, "bent", 0),
            atMost(1.0, currentBend, "back", 0)};
}

Condition easeIs30()
{
    return parameterSetTo("ease", 30.0, "ease");
}

/// Returns the branch whose end is nearest to the pointer.
int branchAtPointer(const Timeline &run)
{
    return nearestBranch(sceneOf(run), run.state(), run.state().input.pointer.value_or(sim::Vec2{}));
}

double pointerToBranch(const Timeline &run)
{
    const sim::Vec2 end = endOf(sceneOf(run), run.state(), branchAtPointer(run));
    return sim::length(end - run.state().input.pointer.value_or(sim::Vec2{}));
}

/// Returns the distance from the pointer to the nearest place of a branch, in px.
double pointerToTree(const Timeline &run)
{
    const sim::State &state = run.state();
    const sim::Vec2 pointer = state.input.pointer.value_or(sim::Vec2{});
    double min = std::numeric_limits<double>::infinity();
    for (int i = 0; i < state.pointCount(); ++i) {
        const sim::Vec2 from = state.positionOf(i), along = endOf(sceneOf(run), state, i) - from;
        const double share = sim::dot(pointer - from, along) / std::max(1e-9, sim::dot(along, along));
        min = std::min(min, sim::length(from + std::clamp(share, 0.0, 1.0) * along - pointer));
    }
    return min;
}

double bendAtPointer(const Timeline &run)
{
    return std::abs(bendOf(sceneOf(run), run.state(), branchAtPointer(run)));
}

/// Returns the smallest and the largest distance from the pointer to the end of a branch, in px.
std::pair<double, double> distances(const Timeline &run)
{
    double min = 1e9, max = 0.0;
    for (int i = 0; i < run.state().pointCount(); ++i) {
        const double distance = sim::length(endOf(sceneOf(run), run.state(), i) - *run.state().input.pointer);
        min = std::min(min, distance);
        max = std::max(max, distance);
    }
    return {min, max};
}

Condition otherTree()
{
    return {[](const Timeline &run) { return !isSetTo(run, "spread", 30.0) && run.cursor().frame > 0; }};
}

Check anotherTree()
{
    return {
        .id = "another_tree",
        .conditions = {otherTree(), blowing(), atLeast(10.0, currentBend, "bent", 0)},
    };
}

/// The run is compared with one by the other formula, and the wind blows.
Conditions comparesFormulas()
{
    return {
        comparisonDiffers("formula"),
        {isBlowing, "blowing"},
        playedSinceFork(),
    };
}

/// Returns whether the trunk leans towards the pointer, from which the wind came.
bool swungPast(const Timeline &run)
{
    if (isBlowing(run) || std::abs(trunkAngle(run)) < 0.5)
        return false;
    const double fromLeft = run.state().positionOf(0).x - run.state().input.pointer->x;
    return trunkAngle(run) * fromLeft < 0.0;
}

/// Returns whether the gust has reached some branches, but not all.
bool isGustArriving(const Timeline &run)
{
    const auto [min, max] = distances(run);
    return run.state().gustExtent.front > min && run.state().gustExtent.front < max;
}

}

std::vector<Check> trunkChecks()
{
    return {
        {
            .id = "published",
            .conditions = {{isPublished},
                           {[](const Timeline &run) { return isSetTo(run, "base_length", 100.0); },
                            "length"}},
        },
        {
            .id = "high",
            .conditions = [](const Timeline &run) { return isSetTo(run, "base_length", 200.0); },
        },
    };
}

std::vector<Check> branchesChecks()
{
    return {
        {
            .id = "right_angle",
            .conditions = [](const Timeline &run) { return isSetTo(run, "spread", 90.0); },
        },
        {
            .id = "slope",
            .conditions = {{[](const Timeline &run) { return isSetTo(run, "slope", 0.7); }},
                           {[](const Timeline &run) { return isSetTo(run, "min_scale", 0.2); }, "smallest"}},
        },
        {
            .id = "three_branches",
            .conditions =
                {
                    {[](const Timeline &run) { return !isSetTo(run, "min_scale", 0.2); }},
                    {[](const Timeline &run) { return run.state().pointCount() == 3; }, "three",
                     [](const Timeline &run) { return static_cast<double>(run.state().pointCount()); }, 0},
                },
        },
    };
}

std::vector<Check> randomnessChecks()
{
    return {
        {
            .id = "none",
            .conditions = [](const Timeline &run) { return isSetTo(run, "jitter", 0.0); },
        },
        {
            .id = "too_much",
            .conditions = [](const Timeline &run) { return isSetTo(run, "jitter", 60.0); },
        },
        {
            .id = "gallery",
            .conditions = [](const Timeline &run) { return !isSetTo(run, "spread", 30.0); },
        },
    };
}

std::vector<Check> towardsPointerChecks()
{
    return {
        {
            .id = "hold",
            .conditions =
                {
                    blowing(),
                    {[](const Timeline &run) { return !isPublished(run); }, "corrected"},
                    pointingAtPointer(),
                },
        },
        {
            .id = "published",
            .conditions = {{isPublished}, blowing(), pointingAtPointer()},
        },
        {
            .id = "let_go",
            .conditions =
                {
                    windReleased(),
                    atLeast(
                        45.0, [](const Timeline &run) { return std::abs(trunkAngle(run)); }, "lean", 0),
                },
        },
    };
}

std::vector<Check> windChecks()
{
    return {
        {
            .id = "lean",
            .conditions = {blowing(), trunkLeans(60.0)},
        },
        {
            .id = "ease",
            .conditions = {easeIs30(), blowing(), unchangedButtonFor(10)},
        },
        {
            .id = "published",
            .conditions = comparesFormulas(),
        },
    };
}

std::vector<Check> restChecks()
{
    return {
        {
            .id = "return",
            .conditions = returned(windReleased(), windReleased()),
        },
        {
            .id = "ease",
            .conditions = returned(easeIs30(), windReleasedSinceSet("ease")),
        },
        {
            .id = "after_return",
            .conditions =
                {
                    insideFrame(),
                    blowing(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::spring;
                     },
                     "phase"},
                    {[](const Timeline &run) { return currentBend(run) > 1.0; }, "bent"},
                },
        },
    };
}

std::vector<Check> distanceChecks()
{
    return {
        {
            .id = "near",
            .conditions =
                {
                    blowing(),
                    atMost(20.0, pointerToBranch, "close", 0),
                    atLeast(30.0, bendAtPointer, "bent", 0),
                },
        },
        {
            .id = "far",
            .conditions =
                {
                    blowing(),
                    atLeast(80.0, pointerToTree, "far", 0),
                    unchangedButtonFor(60),
                    atMost(15.0, currentBend, "hardly_bent", 0),
                },
        },
        {
            .id = "published",
            .conditions = comparesFormulas(),
        },
    };
}

std::vector<Check> thicknessChecks()
{
    return {
        {
            .id = "twig",
            .conditions =
                {
                    blowing(),
                    atLeast(20.0, currentBend, "bent", 0),
                    atLeast(
                        20.0,
                        [](const Timeline &run) {
                            return currentBend(run) / std::max(1e-9, std::abs(trunkAngle(run)));
                        },
                        "than_trunk", 0),
                },
        },
        {
            .id = "strong_wind",
            .conditions = {parameterSetTo("wind", 20.0), blowing(), trunkLeans(10.0)},
        },
        {
            .id = "published",
            .conditions = comparesFormulas(),
        },
    };
}

std::vector<Check> turbulenceChecks()
{
    return {
        {
            .id = "tremble",
            .conditions = {blowing(), unchangedButtonFor(60)},
        },
        {
            .id = "calm",
            .conditions =
                {
                    comparisonDiffers("turbulence"),
                    parameterSetTo("turbulence", 0.0, "turbulence"),
                    blowing(),
                    playedSinceFork(),
                },
        },
        anotherTree(),
    };
}

std::vector<Check> realSwayChecks()
{
    return {
        {
            .id = "swing_past",
            .conditions =
                {
                    windReleased(),
                    {swungPast, "swings_past"},
                },
        },
        {
            .id = "gust",
            .conditions =
                {
                    blowing(),
                    {isGustArriving, "gust"},
                },
            .onlyWhilePaused = true,
        },
        {
            .id = "no_damping",
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    windReleasedSinceSet("damp"),
                    atLeast(
                        300.0,
                        [](const Timeline &run) { return static_cast<double>(framesSinceButton(run)); },
                        "frames", 0),
                    {[](const Timeline &run) { return currentBend(run) > 1.0; }, "bent"},
                },
        },
        anotherTree(),
    };
}

}
