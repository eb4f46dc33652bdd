#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;
using sim::Values;

namespace accuracy {

namespace {

/// Returns the length of the method's steps in frames. Infinite for adaptive steps.
double stepLength(const Timeline &run)
{
    const sim::StepSize &step = run.script().step;
    return step.isAdaptive() ? std::numeric_limits<double>::infinity() : step.h;
}

bool isAdaptive(const Timeline &run)
{
    return run.script().step.isAdaptive();
}

/// Returns whether the cursor is between two frames, after frame 0.
bool isBetweenFrames(const Timeline &run)
{
    return run.cursor().phase == 0 && run.cursor().frame > 0;
}

/// Returns whether the learner has changed nothing but method and step.
bool isUnchanged(const Timeline &run, const Values &defaultValues)
{
    const sim::Script &script = run.script();
    return script.values == defaultValues && script.input.empty() && script.bodies.empty() &&
           script.effectsOff.empty();
}

/// Returns the error at the cursor, in px. NaN inside a frame.
double errorOf(const Exact &exact, const Timeline &run)
{
    return isBetweenFrames(run) ? exact->distance(run.script(), run.state(), run.cursor().frame)
                                : std::numeric_limits<double>::quiet_NaN();
}

/// Returns the energy drift at the cursor, in percent. NaN inside a frame.
double driftOf(const Exact &exact, const Timeline &run)
{
    return isBetweenFrames(run)
               ? energyDrift(*exact, run.script(), run.track().interval().scene, run.state(), run.values())
               : std::numeric_limits<double>::quiet_NaN();
}

/// Returns the average number of force evaluations per frame, from the start to the cursor.
double averageForceEvaluations(const Timeline &run)
{
    if (isAdaptive(run))
        return run.state().forceEvaluations() /
               static_cast<double>(std::max<std::int64_t>(1, run.cursor().frame));
    return forceEvaluations(run.script(), run.state(), nullptr);
}

Condition oneFrameSteps()
{
    return stepIs(1.0, "step");
}

Condition adaptive(const QString &sentence = {})
{
    return {isAdaptive, sentence};
}

/// The cursor is exactly at `frame`.
Condition exactlyAt(std::int64_t frame)
{
    return {[frame](const Timeline &run) {
                return run.cursor() == sim::Cursor{frame, 0};
            },
            "frame", [](const Timeline &run) { return static_cast<double>(run.cursor().frame); }, 0};
}

Condition unchanged(const Values &defaultValues)
{
    return {[defaultValues](const Timeline &run) { return isUnchanged(run, defaultValues); }, "unchanged"};
}

Condition errorBelow(const Exact &exact, double max, int decimals)
{
    return {[exact, max](const Timeline &run) { return errorOf(exact, run) < max; }, "error",
            [exact](const Timeline &run) { return errorOf(exact, run); }, decimals};
}

Condition driftAtLeast(const Exact &exact, double percent)
{
    return atLeast(
        percent, [exact](const Timeline &run) { return driftOf(exact, run); }, "drift");
}

/// The run uses the method `id` with steps of 1/16 frame, and the cursor is at frame 60.
Conditions toFrame60By(const char *id, const QString &choose)
{
    return {stepIs(1.0 / 16), runsMethod(id, choose), exactlyAt(60)};
}

/// Returns the state one frame before the cursor.
sim::State stateBefore(const Timeline &run)
{
    return run.track().stateAt(std::max<std::int64_t>(0, run.cursor().frame - 1));
}

/// Returns how close the foot came to the body in the last frame, in px. A fast foot is close between two frames.
double closestToBody(const Timeline &run)
{
    const sim::Scene &scene = run.track().interval().scene;
    const int foot = scene.find("foot"), body = scene.find("body");
    const sim::State before = stateBefore(run);
    const sim::Vec2 from = before.positionOf(foot) - before.positionOf(body);
    const sim::Vec2 way = run.state().positionOf(foot) - run.state().positionOf(body) - from;
    const double square = dot(way, way);
    const double part = square > 0.0 ? std::clamp(-dot(from, way) / square, 0.0, 1.0) : 0.0;
    return sim::length(from + part * way);
}

/// Returns the shorter of the steps at the cursor and one frame before, in frames.
double shortestStep(const Timeline &run)
{
    return std::min(lastStep(run.state()), lastStep(stateBefore(run)));
}

/// Returns the distance of the foot from the centre, in px.
double footFromCentre(const Timeline &run)
{
    return sim::length(positionOf(run, "foot") - sim::Vec2{270.0, 200.0});
}

}

std::vector<Check> bigStepChecks(const Exact &exact)
{
    return {
        {
            .id = "eighth_frame",
            .conditions = {stepIs(0.125), exactlyAt(100)},
        },
        {
            .id = "two_frames",
            .conditions =
                {
                    stepIs(2.0),
                    atLeast(
                        100.0, [exact](const Timeline &run) { return errorOf(exact, run); }, "error", 0),
                },
        },
        {
            .id = "five_frames",
            .conditions =
                {
                    stepIs(5.0),
                    parameterSetTo("k", 0.2, "k"),
                    {[](const Timeline &run) {
                         return isBetweenFrames(run) && !(footFromCentre(run) < 1000.0);
                     },
                     "away", footFromCentre, 0},
                },
        },
        {
            .id = "slow_swing",
            .conditions =
                {
                    parameterSetTo("k", 0.02),
                    {[](const Timeline &run) { return run.script().values["k"] <= 0.025; }, "from_start"},
                    oneFrameSteps(),
                    playedTo(100),
                },
        },
    };
}

std::vector<Check> energyChecks(const Exact &exact)
{
    return {
        {
            .id = "explicit_euler",
            .conditions = {runsMethod("explicit_euler"), driftAtLeast(exact, 100.0)},
        },
        {
            .id = "small_step",
            .conditions =
                {
                    stepIs(0.125),
                    runsMethod("explicit_euler", "method"),
                    driftAtLeast(exact, 10.0),
                },
        },
        {
            .id = "verlet",
            .conditions = {runsMethod("velocity_verlet"), oneFrameSteps(), playedTo(200)},
        },
    };
}

std::vector<Check> halveChecks(const Exact &exact, const Values &defaultValues)
{
    return {
        {
            .id = "euler",
            .conditions = toFrame60By("semi_implicit_euler", "method"),
        },
        {
            .id = "midpoint",
            .conditions = toFrame60By("midpoint", "method"),
        },
        {
            .id = "runge_kutta",
            .conditions = toFrame60By("rk4", "method"),
        },
        {
            .id = "cheap",
            .conditions =
                {
                    {[](const Timeline &run) {
                        return !usesMethod(run, "semi_implicit_euler") || stepLength(run) != 1.0;
                    }},
                    unchanged(defaultValues),
                    exactlyAt(60),
                    atMost(16.0, averageForceEvaluations, "price", 0),
                    errorBelow(exact, 0.01, 3),
                },
        },
    };
}

std::vector<Check> adaptChecks(const Exact &exact, const Values &defaultValues)
{
    return {
        {
            .id = "tolerance",
            .conditions =
                {
                    {[](const Timeline &run) {
                        return isAdaptive(run) && run.script().step.tolerance == 0.1;
                    }},
                    unchanged(defaultValues),
                    exactlyAt(150),
                },
        },
        {
            .id = "throw",
            .conditions =
                {
                    released("foot"),
                    thrownAtLeast(),
                    adaptive("method"),
                    {[](const Timeline &run) { return closestToBody(run) <= 10.0; }, "close"},
                    {[](const Timeline &run) { return shortestStep(run) < 1.0; }, "short_step", shortestStep},
                },
        },
        {
            .id = "fixed_step",
            .conditions =
                {
                    runsMethod("rk4"),
                    unchanged(defaultValues),
                    exactlyAt(150),
                    errorBelow(exact, 0.2, 2),
                },
        },
    };
}

std::vector<Check> bounceChecks(const Exact &exact, const Values &defaultValues)
{
    return {
        {
            .id = "halve",
            .conditions =
                {
                    stepIs(0.125),
                    runsMethod("rk4", "method"),
                    playedTo(200),
                },
        },
        {
            .id = "dormand_prince",
            .conditions = {adaptive(), unchanged(defaultValues), exactlyAt(200), errorBelow(exact, 1e-6, 7)},
        },
        {
            .id = "rest",
            .conditions =
                {
                    parameterSetTo("bounce", 0.5),
                    adaptive("method"),
                    {[](const Timeline &run) {
                         return isBetweenFrames(run) && run.state().restingContacts.any();
                     },
                     "lies"},
                },
        },
    };
}

std::vector<Check> budgetChecks(const Values &defaultValues)
{
    const Conditions reachedFrame200 = {{[](const Timeline &run) {
                                            return !usesMethod(run, "semi_implicit_euler") ||
                                                   stepLength(run) != 1.0;
                                        }},
                                        unchanged(defaultValues),
                                        playedTo(200)};
    constexpr double noTimeLimit = std::numeric_limits<double>::infinity();
    return {
        {
            .id = "one_pixel",
            .conditions = reachedFrame200,
            .budget = Budget{.error = 1.0, .nsPerFrame = noTimeLimit, .frames = 200},
        },
        {
            .id = "half_microsecond",
            .conditions = reachedFrame200,
            .budget = Budget{.error = 1.0, .nsPerFrame = 500.0, .frames = 200},
        },
        {
            .id = "tenth_pixel",
            .conditions = reachedFrame200,
            .budget = Budget{.error = 0.1, .nsPerFrame = 1000.0, .frames = 200},
        },
    };
}

std::vector<Check> crowdChecks()
{
    constexpr std::int64_t frames = 60; ///< frames
    return {
        {
            .id = "twice_as_many",
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["creatures"] >= 20'000.0; }},
                    unchangedFor("creatures", frames),
                },
        },
        {
            .id = "no_bounce",
            .conditions =
                {
                    parameterSetTo("bounce", 0.0),
                    {[](const Timeline &run) {
                         return isBetweenFrames(run) && (run.state().velocity.abs() <= stillness).all() &&
                                isStill(run);
                     },
                     "still"},
                },
        },
        {
            .id = "no_gravity",
            .conditions = {parameterSetTo("gravity", 0.0), unchangedFor("gravity", frames)},
        },
    };
}

}
