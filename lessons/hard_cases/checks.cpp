#include "checks.h"

#include "cases.h"
#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/hard_cases/text.h"
#include "scenes.h"
#include "sim/pipeline/method.h"
#include "sim/run/timeline.h"
#include "view.h"

#include <QCoreApplication>
#include <QLocale>

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
            Text::tr("play on to frame %2. This is frame %1.")
                .replace(QStringLiteral("%2"), QString::number(frame)),
            [](const Timeline &run) { return static_cast<double>(run.cursor().frame); }, 0};
}

/// The parameter `id` had `value` at the start of the run and has it at the cursor. The learner knows it as
/// `name`.
Condition setFromStart(const char *id, const QString &name, double value)
{
    return {
        [id, value](const Timeline &run) {
            return std::abs(run.script().values[id] - value) <= 0.005 && isSetTo(run, id, value);
        },
        Text::tr("press **Home**, and set **%1** to %2 there.").arg(name, QLocale().toString(value, 'g', 6))};
}

Condition oneFrameSteps()
{
    return stepIs(1.0, Text::tr("choose steps of **1 frame**."));
}

Condition halfFrameSteps()
{
    return stepIs(0.5, Text::tr("choose steps of **1/2 frame**."));
}

/// The method has a stability limit.
Condition hasStabilityLimit()
{
    return {hasLimit, Text::tr("choose **Semi-implicit Euler** as method.")};
}

Condition atRest()
{
    return {[](const Timeline &run) { return run.cursor().frame > 0 && isStill(run); },
            Text::tr("let time run (**Space**) until it rests.")};
}

Condition published()
{
    return runsMethod("published", Text::tr("choose **Published** as method."));
}

Condition untouched()
{
    return {[](const Timeline &run) { return run.script().input.empty(); },
            Text::tr("press **Home**, change nothing on the way, and do not touch it.")};
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
    return {[=](const Timeline &run) { return largestLegError(run, length) < max; },
            Text::tr("try something else: the worst leg is %1 px off."),
            [=](const Timeline &run) { return largestLegError(run, length); }, max < 0.1 ? 3 : 1};
}

Condition feetApart()
{
    return {[](const Timeline &run) { return smallestFootDistance(run) > 10.0; },
            Text::tr("play on until all feet are more than 10 px apart. The nearest two: %1 px."),
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
            Text::tr("set **radius** to 0, play on for 60 frames, and set it to 50 again.")};
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
    return {[](const Timeline &run) { return isUnchangedCase(run.script()); },
            Text::tr("choose the case again, and change nothing but method and step.")};
}

}

std::vector<Try> limitTries()
{
    return {
        {
            .text = Text::tr(
                "Choose **1/2 frame** as step, and play to frame 100. It swings, hardly farther than the "
                "crosses."),
            .conditions = {halfFrameSteps(), hasStabilityLimit(), setFromStart("k", Text::tr("k"), 4.01),
                           playedWithoutStop(100)},
            .hint = Text::tr(
                "Above the picture, press **Step** and choose **1/2 frame**. Press **Space** and wait "
                "four seconds."),
        },
        {
            .text = Text::tr(
                "With steps of 1 frame, go to frame 0 and set **k** to 3.9. Play to frame 100: six times as "
                "far, and it always comes back."),
            .conditions =
                {
                    parameterSetTo("k", 3.9),
                    setFromStart("k", Text::tr("k"), 3.9),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    playedWithoutStop(100),
                },
            .hint = Text::tr(
                "Press **Home**, type 3.9 into the field beside **k**, press **Space**, and wait four "
                "seconds."),
        },
        {
            .text = Text::tr(
                "At k = 4.01, go to frame 0 and set **damp** to 0.9. The limit is 4.22 now: wait until it "
                "rests."),
            .conditions =
                {
                    parameterSetTo("damp", 0.9),
                    setFromStart("damp", Text::tr("damp"), 0.9),
                    setFromStart("k", Text::tr("k"), 4.01),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    atRest(),
                },
            .hint =
                Text::tr("Press **Home**, type 0.9 into the field beside **Damping**, press **Space**, and "
                         "wait."),
        },
    };
}

std::vector<Try> runawayTries()
{
    return {
        {
            .text = Text::tr(
                "Choose **Semi-implicit Euler** as method, and play to frame 200. Where is the middle?"),
            .conditions =
                {
                    runsMethod("semi_implicit_euler"),
                    playedWithoutStop(200),
                    {[](const Timeline &run) {
                         return sim::length(centreOfPoints(run) - sim::Vec2{300.0, 230.0}) < 1e-6;
                     },
                     Text::tr("press **Home** and choose the method there: the pair has moved before.")},
                },
            .hint = Text::tr("Above the picture, press **Method** and choose **Semi-implicit Euler**. Press "
                             "**Space** and wait seven seconds."),
            .answer =
                Text::tr("Where it was at the start. Both pulls are taken at one moment, so they cancel."),
        },
        {
            .text = Text::tr(
                "With **Published** and steps of 1 frame, go to frame 0 and set **k** to 0.2. Wait until it "
                "rests: 157 px from where it belongs."),
            .conditions =
                {
                    parameterSetTo("k", 0.2),
                    setFromStart("k", Text::tr("k"), 0.2),
                    published(),
                    oneFrameSteps(),
                    atRest(),
                },
            .hint =
                Text::tr("Choose **Published** as method and **1 frame** as step. Press **Home**, type 0.2 "
                         "beside **k**, press **Space**, and wait."),
        },
        {
            .text = Text::tr(
                "**Published** at k = 0.3, with steps of **1/4 frame**: wait until it rests. Less wrong, and "
                "never right."),
            .conditions =
                {
                    {[](const Timeline &run) { return stepLength(run) == 0.25; }},
                    published(),
                    setFromStart("k", Text::tr("k"), 0.3),
                    atRest(),
                },
            .hint = Text::tr("Choose **Published** as method and **1/4 frame** as step. Press **Space** and "
                             "wait."),
        },
    };
}

std::vector<Try> manyFeetTries()
{
    const auto feetAtLeast = [](double min) {
        return Condition{[min](const Timeline &run) { return run.script().values["feet"] >= min; },
                         Text::tr("set **feet** to 60 at frame 0.")};
    };
    const Condition legs = {
        [](const Timeline &run) { return largestLegError(run, run.values()["radius"]) < 1.0; },
        Text::tr("not all legs have their length: the worst is %1 px off."),
        [](const Timeline &run) { return largestLegError(run, run.values()["radius"]); }};
    return {
        {
            .text =
                Text::tr("With steps of 1 frame, go to frame 0 and set **feet** to 38. Wait until it rests."),
            .conditions =
                {
                    parameterSetTo("feet", 38),
                    setFromStart("feet", Text::tr("feet"), 38),
                    setFromStart("k", Text::tr("k"), 0.2),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    atRest(),
                    legs,
                },
            .hint = Text::tr(
                "Press **Home**, type 38 into the field beside **Feet**, press **Space**, and wait."),
        },
        {
            .text = Text::tr("Sixty feet at rest with steps of **1/2 frame**."),
            .conditions = {halfFrameSteps(), hasStabilityLimit(), feetAtLeast(60), atRest(), legs},
            .hint =
                Text::tr("Above the picture, press **Step** and choose **1/2 frame**. Press **Space** and "
                         "wait."),
        },
        {
            .text = Text::tr(
                "Sixty feet at rest with steps of 1 frame: how soft must the springs be? (Go to frame 0 "
                "first.)"),
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["k"] < 0.2; }},
                    {[](const Timeline &run) { return run.script().values["k"] < 0.2; },
                     Text::tr("press **Home**, and set **k** there.")},
                    {[](const Timeline &run) { return run.script().values["damp"] >= 0.85; },
                     Text::tr("set **damp** to 0.85.")},
                    feetAtLeast(60),
                    oneFrameSteps(),
                    hasStabilityLimit(),
                    atRest(),
                    legs,
                },
            .hint =
                Text::tr("Press **Home**, type 0.1 into the field beside **k**, press **Space**, and wait."),
            .answer = Text::tr("k = 0.13 holds, 0.14 does not."),
        },
    };
}

std::vector<Try> onePlaceTries()
{
    const Condition otherMethod = {[](const Timeline &run) { return !usesMethod(run, "published"); },
                                   Text::tr("choose **Semi-implicit Euler** as method.")};
    return {
        {
            .text = Text::tr(
                "Choose **Semi-implicit Euler**, and play from frame 0 to 60: five feet, all apart."),
            .conditions = {runsMethod("semi_implicit_euler"), untouched(), playedWithoutStop(60),
                           feetApart()},
            .hint = Text::tr("Above the picture, press **Method** and choose **Semi-implicit Euler**. Press "
                             "**Space** and wait two seconds."),
        },
        {
            .text = Text::tr(
                "**Published**: drag one foot up, 20 px or more out of the line, let go, and wait until "
                "it rests. "
                "Did the others follow one by one, or as one?"),
            .conditions = {released(), published(), draggedAtLeast(20.0), idleFor(20), atRest()},
            .hint = Text::tr(
                "Choose **Published** as method, press **Space**, and wait two seconds. Take a foot, "
                "carry it up, let go, and wait."),
            .answer = Text::tr("As one. The other four lie in one place, and nothing tells them apart."),
        },
        {
            .text = Text::tr(
                "With any other method and all feet apart, set **radius** to 0: all fall into one place. "
                "After 60 frames set it to 50 again. Do they part?"),
            .conditions =
                {
                    {[](const Timeline &run) { return framesSinceSet(run, "radius") < run.cursor().frame; }},
                    otherMethod,
                    collapsed(),
                    parameterSetTo("radius", 50.0, Text::tr("set **radius** to 50 again.")),
                    feetApart(),
                },
            .hint = Text::tr("Choose **Semi-implicit Euler** as method and play two seconds. Type 0 beside "
                             "**Radius** and wait two seconds. Then type 50, and wait again."),
            .answer = Text::tr("Yes. Other methods give points in one place directions of their own, all "
                               "different."),
        },
    };
}

std::vector<Try> stiffTries()
{
    return {
        {
            .text = Text::tr("**Semi-implicit Euler**: find a step with which the stiff legs come to rest."),
            .conditions =
                {
                    {[](const Timeline &run) { return stepLength(run) != 1.0; }},
                    hasStabilityLimit(),
                    {[](const Timeline &run) { return run.script().values["k"] >= 1000.0; },
                     Text::tr("press **Home**, and set **k** to 1000 there.")},
                    {[](const Timeline &run) { return !run.stop(); },
                     Text::tr("press **Home**, and try a smaller step.")},
                    playedWithoutStop(20),
                    atRest(),
                    legErrorsBelow(50.0, 0.1),
                },
            .hint =
                Text::tr("Above the picture, press **Step** and choose **1/64 frame**. Press **Space** and "
                         "wait."),
        },
        {
            .text = Text::tr(
                "**Backward Euler**, steps of 1 frame: go to frame 0, type 1000000 as **k**, and play "
                "30 frames."),
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["k"] >= 1e6; }},
                    setFromStart("k", Text::tr("k"), 1e6),
                    runsMethod("backward_euler", Text::tr("choose **Backward Euler** as method.")),
                    oneFrameSteps(),
                    playedWithoutStop(30),
                },
            .hint = Text::tr(
                "Choose **Backward Euler** as method. Press **Home**, type 1000000 beside **k**, and "
                "press **Space**."),
        },
        {
            .text = Text::tr(
                "The price: **Backward Euler** with **k** 0.2 and **damp** 1, from frame 0. Nothing slows "
                "the legs. Wait until they have stopped swinging."),
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    setFromStart("damp", Text::tr("damp"), 1.0),
                    setFromStart("k", Text::tr("k"), 0.2),
                    runsMethod("backward_euler", Text::tr("choose **Backward Euler** as method.")),
                    oneFrameSteps(),
                    playedWithoutStop(60),
                    legErrorsBelow(50.0, 0.5),
                },
            .hint =
                Text::tr("Choose **Backward Euler** as method. Press **Home**, type 0.2 beside **k** and 1 "
                         "beside **Damping**, press **Space**, and wait."),
        },
    };
}

std::vector<Try> contradictionTries()
{
    return {
        {
            .text = Text::tr(
                "Springs, steps of 1 frame: go to frame 0 and set **k** to 1. They share the error: wait "
                "until they rest."),
            .conditions =
                {
                    parameterSetTo("k", 1.0),
                    setFromStart("k", Text::tr("k"), 1.0),
                    parameterSetTo("made_of", 0.0, Text::tr("choose **springs**.")),
                    oneFrameSteps(),
                    setFromStart("longest", Text::tr("longest"), 200.0),
                    playedWithoutStop(30),
                    atRest(),
                },
            .hint =
                Text::tr("Press **Home**, type 1 into the field beside **k**, press **Space**, and wait."),
        },
        {
            .text = Text::tr("Choose **sticks**, and wait until they rest. Which of them has its length?"),
            .conditions =
                {
                    parameterSetTo("made_of", 1.0),
                    setFromStart("longest", Text::tr("longest"), 200.0),
                    playedWithoutStop(30),
                    atRest(),
                },
            .hint = Text::tr("Choose **sticks** beside **Made of**, press **Space**, and wait."),
            .answer = Text::tr("The long one: it comes last in the list. The two short ones bear the error."),
        },
        {
            .text = Text::tr(
                "Sticks: make **longest** so short that there is such a triangle, and all three are right "
                "to 0.1 px."),
            .conditions =
                {
                    {[](const Timeline &run) { return !isSetTo(run, "longest", 200.0); }},
                    parameterSetTo("made_of", 1.0, Text::tr("choose **sticks**.")),
                    playedWithoutStop(20),
                    {[](const Timeline &run) { return sideError(run) < 0.1; },
                     Text::tr("make **longest** shorter, or play on. The worst stick is %1 px off."),
                     sideError},
                },
            .hint = Text::tr(
                "Two sticks of 20 px reach 40 px at most. Choose **sticks** beside **Made of**, type 30 "
                "beside **Longest**, press **Space**, and wait."),
        },
    };
}

std::vector<Try> longRunTries()
{
    const Condition springs = setFromStart("k", Text::tr("k"), 0.5);
    const Condition undamped = setFromStart("damp", Text::tr("damp"), 1.0);
    const auto rungeKutta = runsMethod("rk4", Text::tr("choose **Runge–Kutta 4** as method."));
    return {
        {
            .text = Text::tr("**Runge–Kutta 4**, steps of 1 frame: go to frame 5000. What is left?"),
            .conditions =
                {
                    {[](const Timeline &run) { return run.cursor().frame > 1000 && stepLength(run) == 1.0; }},
                    rungeKutta,
                    springs,
                    undamped,
                    untouched(),
                    playedWithoutStop(5000),
                },
            .hint = Text::tr("Press **Ctrl+G**, type 5000, and press **Enter**."),
            .answer = Text::tr("2 px of 120 px."),
        },
        {
            .text = Text::tr("The same with steps of **1/2 frame**: a thirty-second of the loss a frame."),
            .conditions = {halfFrameSteps(), rungeKutta, springs, undamped, untouched(),
                           playedWithoutStop(5000)},
            .hint =
                Text::tr("Above the picture, press **Step** and choose **1/2 frame**. Press **Ctrl+G**, type "
                         "5000, and press **Enter**."),
        },
        {
            .text = Text::tr("**Velocity Verlet**, steps of 1 frame, to frame 20000: it swings as at first."),
            .conditions =
                {
                    runsMethod("velocity_verlet"),
                    oneFrameSteps(),
                    springs,
                    undamped,
                    untouched(),
                    playedWithoutStop(20000),
                },
            .hint = Text::tr(
                "Choose **Velocity Verlet** as method and **1 frame** as step. Press **Ctrl+G**, type "
                "20000, and press **Enter**."),
        },
    };
}

std::vector<Try> tortureTries()
{
    return {
        {
            .text = Text::tr(
                "Case **nearly rigid**: find a method that claims it, and play until it is at rest."),
            .conditions =
                {
                    caseIs("stiffness_1e9"),
                    unchangedCase(),
                    {[](const Timeline &run) { return !run.stop(); },
                     Text::tr("this method cannot hold it. Try one that claims it, from frame 0.")},
                    playedWithoutStop(10),
                    {[](const Timeline &run) {
                         return sim::length(run.state().positionOf(0) - centre) <= 1e-6;
                     },
                     Text::tr("play on until it is at rest.")},
                },
            .hint = Text::tr(
                "Choose **nearly rigid** beside **Case**, and **Backward Euler** as method above the "
                "picture. Press **Space** and wait."),
        },
        {
            .text = Text::tr(
                "Case **torn away**: find a method with which the legs have their length again before "
                "frame 400. Which is the quickest?"),
            .conditions =
                {
                    caseIs("dragged_1e9"),
                    unchangedCase(),
                    playedWithoutStop(30),
                    {[](const Timeline &run) { return run.cursor().frame < 400; },
                     Text::tr("frame 400 is past. Try another method, from frame 0.")},
                    legErrorsBelow(50.0, 0.01),
                    atRest(),
                },
            .hint =
                Text::tr("Choose **torn away** beside **Case**, and **Semi-implicit Euler** or **Backward "
                         "Euler** as method. Press **Space** and wait."),
            .answer = Text::tr("Backward Euler: it has them right at frame 37. It slows what swings."),
        },
        {
            .text = Text::tr(
                "Make any case **stop**: find one that a method does not claim, and see who went first."),
            .conditions =
                {
                    {[](const Timeline &run) {
                        return run.stop() && run.cursor().frame == run.stop()->frame;
                    }},
                    unchangedCase(),
                },
            .hint = Text::tr("Choose **Semi-implicit Euler** as method, and a case with stiff springs. Press "
                             "**Space** and wait until the run stops by itself."),
        },
    };
}

}
