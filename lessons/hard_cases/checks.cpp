#include "checks.h"

#include "cases.h"
#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "scenes.h"
#include "sim/pipeline/method.h"
#include "sim/run/timeline.h"
#include "view.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;

namespace hard_cases {

namespace {

/// Returns whether the method has a stability limit: its steps can be too long for stiff springs.
bool hasLimit(const Timeline &run)
{
    return run.script().method->stepLimit() == sim::StepLimit::stiffness;
}

/// Returns the length of the method's steps, in frames. 0 for adaptive steps.
double stepLength(const Timeline &run)
{
    return run.script().step.isAdaptive() ? 0.0 : run.script().step.h;
}

/// The run has not stopped, and the cursor is between two frames, at `frame` or later.
Condition playedWithoutStop(std::int64_t frame)
{
    return {[frame](const Timeline &run) {
                return run.cursor().phase == 0 && run.cursor().frame >= frame && !run.stop();
            },
            "frame", [](const Timeline &run) { return static_cast<double>(run.cursor().frame); }, 0};
}

/// The parameter `id` had `value` at the start of the run and has it at the cursor.
Condition setFromStart(const char *id, double value)
{
    return {[id, value](const Timeline &run) {
                return std::abs(run.script().values[id] - value) <= 0.005 && isSetTo(run, id, value);
            },
            QStringLiteral("%1_from_start").arg(QLatin1String(id))};
}

Condition oneFrameSteps()
{
    return stepIs(1.0, "step");
}

Condition halfFrameSteps()
{
    return stepIs(0.5, "step");
}

/// The method has a stability limit.
Condition hasStabilityLimit()
{
    return {hasLimit, "method"};
}

Condition atRest()
{
    return {[](const Timeline &run) { return run.cursor().frame > 0 && isStill(run); }, "rest"};
}

Condition published()
{
    return runsMethod("published", "method");
}

Condition untouched()
{
    return {[](const Timeline &run) { return run.script().input.empty(); }, "untouched"};
}

/// Returns the largest error of a leg of rest length `length`, in px.
double largestLegError(const Timeline &run, double length)
{
    const sim::State &state = run.state();
    const int body = state.pointCount() - 1;
    double worst = 0.0;
    for (int i = 0; i < body; ++i)
        worst = std::max(worst, std::abs(sim::length(state.positionOf(i) - state.positionOf(body)) - length));
    return worst;
}

/// Returns the distance between the two nearest feet, in px.
double smallestFootDistance(const Timeline &run)
{
    const sim::State &state = run.state();
    const int body = state.pointCount() - 1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < body; ++i) {
        for (int j = 0; j < i; ++j)
            nearest = std::min(nearest, sim::length(state.positionOf(i) - state.positionOf(j)));
    }
    return nearest;
}

/// The length of every leg differs from `length` by less than `max` px.
Condition legErrorsBelow(double length, double max)
{
    return {[=](const Timeline &run) { return largestLegError(run, length) < max; }, "legs",
            [=](const Timeline &run) { return largestLegError(run, length); }, max < 0.1 ? 3 : 1};
}

Condition feetApart()
{
    return {[](const Timeline &run) { return smallestFootDistance(run) > 10.0; }, "apart",
            smallestFootDistance, 0};
}

/// The radius was 0 for 60 frames before it became 50.
Condition collapsed()
{
    return {[](const Timeline &run) {
                std::optional<std::int64_t> since;
                for (const sim::Event &event : run.script().input) {
                    const auto *set = std::get_if<sim::Set>(&event.what);
                    if (!set || set->parameter != "radius")
                        continue;
                    if (since && set->value != 0.0 && event.frame >= *since + 60)
                        return true;
                    since = set->value == 0.0 ? std::optional(event.frame) : std::nullopt;
                }
                return false;
            },
            "collapsed"};
}

/// Returns the largest error of a side of the triangle, in px.
double sideError(const Timeline &run)
{
    const auto error = [&](const char *a, const char *b, double length) {
        return std::abs(distance(run, a, b) - length);
    };
    return std::max({error("p0", "p1", shortStick), error("p1", "p2", shortStick),
                     error("p0", "p2", run.values()["longest"])});
}

Condition caseIs(const char *id)
{
    return {[id](const Timeline &run) { return run.values().integer("case") == caseIndex(id); }};
}

Condition unchangedCase()
{
    return {[](const Timeline &run) { return isUnchangedCase(run.script()); }, "unchanged"};
}

}

std::vector<Check> limitChecks()
{
    return {
        {
            .id = "half_frame",
            .conditions = {halfFrameSteps(), hasStabilityLimit(), setFromStart("k", 4.01),
                           playedWithoutStop(100)},
        },
        {
            .id = "below",
            .conditions =
                {
                    parameterSetTo("k", 3.9),
                    setFromStart("k", 3.9),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    playedWithoutStop(100),
                },
        },
        {
            .id = "damped",
            .conditions =
                {
                    parameterSetTo("damp", 0.9),
                    setFromStart("damp", 0.9),
                    setFromStart("k", 4.01),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    atRest(),
                },
        },
    };
}

std::vector<Check> runawayChecks()
{
    return {
        {
            .id = "euler",
            .conditions =
                {
                    runsMethod("semi_implicit_euler"),
                    playedWithoutStop(200),
                    {[](const Timeline &run) {
                         return sim::length(centreOfPoints(run) - sim::Vec2{300.0, 230.0}) < 1e-6;
                     },
                     "middle"},
                },
        },
        {
            .id = "softer",
            .conditions =
                {
                    parameterSetTo("k", 0.2),
                    setFromStart("k", 0.2),
                    published(),
                    oneFrameSteps(),
                    atRest(),
                },
        },
        {
            .id = "small_steps",
            .conditions =
                {
                    {[](const Timeline &run) { return stepLength(run) == 0.25; }},
                    published(),
                    setFromStart("k", 0.3),
                    atRest(),
                },
        },
    };
}

std::vector<Check> manyFeetChecks()
{
    const auto feetAtLeast = [](double min) {
        return Condition{[min](const Timeline &run) { return run.script().values["feet"] >= min; }, "feet"};
    };
    const Condition legs = {
        [](const Timeline &run) { return largestLegError(run, run.values()["radius"]) < 1.0; }, "legs",
        [](const Timeline &run) { return largestLegError(run, run.values()["radius"]); }};
    return {
        {
            .id = "fewer",
            .conditions =
                {
                    parameterSetTo("feet", 38),
                    setFromStart("feet", 38),
                    setFromStart("k", 0.2),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    atRest(),
                    legs,
                },
        },
        {
            .id = "half_frame",
            .conditions = {halfFrameSteps(), hasStabilityLimit(), feetAtLeast(60), atRest(), legs},
        },
        {
            .id = "softer",
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["k"] < 0.2; }},
                    {[](const Timeline &run) { return run.script().values["k"] < 0.2; }, "from_start"},
                    {[](const Timeline &run) { return run.script().values["damp"] >= 0.85; }, "damp"},
                    feetAtLeast(60),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    atRest(),
                    legs,
                },
        },
    };
}

std::vector<Check> onePlaceChecks()
{
    const Condition otherMethod = {[](const Timeline &run) { return !usesMethod(run, "published"); },
                                   "method"};
    return {
        {
            .id = "apart",
            .conditions = {runsMethod("semi_implicit_euler"), untouched(), playedWithoutStop(60),
                           feetApart()},
        },
        {
            .id = "drag",
            .conditions = {released(), published(), draggedAtLeast(20.0), idleFor(20), atRest()},
        },
        {
            .id = "part_again",
            .conditions =
                {
                    {[](const Timeline &run) { return framesSinceSet(run, "radius") < run.cursor().frame; }},
                    otherMethod,
                    collapsed(),
                    parameterSetTo("radius", 50.0, "radius"),
                    feetApart(),
                },
        },
    };
}

std::vector<Check> stiffChecks()
{
    return {
        {
            .id = "small_step",
            .conditions =
                {
                    {[](const Timeline &run) { return stepLength(run) != 1.0; }},
                    hasStabilityLimit(),
                    {[](const Timeline &run) { return run.script().values["k"] >= 1000.0; }, "k_from_start"},
                    {[](const Timeline &run) { return !run.stop(); }, "no_stop"},
                    playedWithoutStop(20),
                    atRest(),
                    legErrorsBelow(50.0, 0.1),
                },
        },
        {
            .id = "backward_euler",
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["k"] >= 1e6; }},
                    setFromStart("k", 1e6),
                    runsMethod("backward_euler", "method"),
                    oneFrameSteps(),
                    playedWithoutStop(30),
                },
        },
        {
            .id = "price",
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    setFromStart("damp", 1.0),
                    setFromStart("k", 0.2),
                    runsMethod("backward_euler", "method"),
                    oneFrameSteps(),
                    playedWithoutStop(60),
                    legErrorsBelow(50.0, 0.5),
                },
        },
    };
}

std::vector<Check> contradictionChecks()
{
    return {
        {
            .id = "springs",
            .conditions =
                {
                    parameterSetTo("k", 1.0),
                    setFromStart("k", 1.0),
                    parameterSetTo("made_of", 0.0, "springs"),
                    oneFrameSteps(),
                    setFromStart("longest", 200.0),
                    playedWithoutStop(30),
                    atRest(),
                },
        },
        {
            .id = "sticks",
            .conditions =
                {
                    parameterSetTo("made_of", 1.0),
                    setFromStart("longest", 200.0),
                    playedWithoutStop(30),
                    atRest(),
                },
        },
        {
            .id = "shorter",
            .conditions =
                {
                    {[](const Timeline &run) { return !isSetTo(run, "longest", 200.0); }},
                    parameterSetTo("made_of", 1.0, "sticks"),
                    playedWithoutStop(20),
                    {[](const Timeline &run) { return sideError(run) < 0.1; }, "sides", sideError},
                },
        },
    };
}

std::vector<Check> longRunChecks()
{
    const Condition springs = setFromStart("k", 0.5);
    const Condition undamped = setFromStart("damp", 1.0);
    const auto rungeKutta = runsMethod("rk4", "method");
    return {
        {
            .id = "runge_kutta",
            .conditions =
                {
                    {[](const Timeline &run) { return run.cursor().frame > 1000 && stepLength(run) == 1.0; }},
                    rungeKutta,
                    springs,
                    undamped,
                    untouched(),
                    playedWithoutStop(5000),
                },
        },
        {
            .id = "half_frame",
            .conditions = {halfFrameSteps(), rungeKutta, springs, undamped, untouched(),
                           playedWithoutStop(5000)},
        },
        {
            .id = "verlet",
            .conditions =
                {
                    runsMethod("velocity_verlet"),
                    oneFrameSteps(),
                    springs,
                    undamped,
                    untouched(),
                    playedWithoutStop(20000),
                },
        },
    };
}

std::vector<Check> tortureChecks()
{
    return {
        {
            .id = "nearly_rigid",
            .conditions =
                {
                    caseIs("stiffness_1e9"),
                    unchangedCase(),
                    {[](const Timeline &run) { return !run.stop(); }, "no_stop"},
                    playedWithoutStop(10),
                    {[](const Timeline &run) {
                         return sim::length(run.state().positionOf(0) - centre) <= 1e-6;
                     },
                     "rest_at_centre"},
                },
        },
        {
            .id = "torn_away",
            .conditions =
                {
                    caseIs("dragged_1e9"),
                    unchangedCase(),
                    playedWithoutStop(30),
                    {[](const Timeline &run) { return run.cursor().frame < 400; }, "too_late"},
                    legErrorsBelow(50.0, 0.01),
                    atRest(),
                },
        },
        {
            .id = "stop",
            .conditions =
                {
                    {[](const Timeline &run) {
                        return run.stop() && run.cursor().frame == run.stop()->frame;
                    }},
                    unchangedCase(),
                },
        },
    };
}

}
