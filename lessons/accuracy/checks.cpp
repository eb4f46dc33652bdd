#include "checks.h"

#include "lessons/accuracy/text.h"
#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

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
    return stepIs(1.0, Text::tr("choose **1 frame** as step."));
}

Condition adaptive(const QString &todo = {})
{
    return {isAdaptive, todo};
}

/// The cursor is exactly at `frame`.
Condition exactlyAt(std::int64_t frame)
{
    return {
        [frame](const Timeline &run) {
            return run.cursor() == sim::Cursor{frame, 0};
        },
        Text::tr("go to frame %2. This is frame %1.").replace(QStringLiteral("%2"), QString::number(frame)),
        [](const Timeline &run) { return static_cast<double>(run.cursor().frame); }, 0};
}

Condition unchanged(const Values &defaultValues)
{
    return {[defaultValues](const Timeline &run) { return isUnchanged(run, defaultValues); },
            Text::tr("start the step afresh (**Ctrl+R**), and choose nothing but method and step.")};
}

Condition errorBelow(const Exact &exact, double max, int decimals)
{
    return {[exact, max](const Timeline &run) { return errorOf(exact, run) < max; },
            Text::tr("try another method or step. This one is %1 px off."),
            [exact](const Timeline &run) { return errorOf(exact, run); }, decimals};
}

Condition driftAtLeast(const Exact &exact, double percent)
{
    return atLeast(
        percent, [exact](const Timeline &run) { return driftOf(exact, run); },
        Text::tr("play on. The drift is %1 %."));
}

/// The run uses the method `id` with steps of 1/16 frame, and the cursor is at frame 60.
Conditions toFrame60By(const char *id, const QString &choose)
{
    return {stepIs(1.0 / 16), runsMethod(id, choose), exactlyAt(60)};
}

/// Returns the distance of the foot from the centre, in px.
double footFromCentre(const Timeline &run)
{
    return sim::length(positionOf(run, "foot") - sim::Vec2{270.0, 200.0});
}

}

std::vector<Try> bigStepTries(const Exact &exact)
{
    return {
        {
            .text = Text::tr("Choose **1/8 frame** as step, and play to frame 100. How far is it off now?"),
            .conditions = {stepIs(0.125), exactlyAt(100)},
            .hint = Text::tr(
                "Above the picture, press **Step** and choose **1/8 frame**. Click the number beside "
                "**Frame**, type 100, and press **Enter**. How far off it is stands above the parameters."),
            .answer = Text::tr("3 px, instead of 66 px."),
        },
        {
            .text = Text::tr("Choose **2 frames**. Wait until the foot is more than 100 px off."),
            .conditions =
                {
                    stepIs(2.0),
                    atLeast(
                        100.0, [exact](const Timeline &run) { return errorOf(exact, run); },
                        Text::tr("play on. The foot is %1 px off."), 0),
                },
            .hint = Text::tr("Choose **2 frames** as step above the picture, press **Space**, and wait."),
        },
        {
            .text = Text::tr(
                "Type **5 frames** as step. Now k h² is 5, more than 4: each swing throws it farther out. "
                "Wait until it is 1000 px away."),
            .conditions =
                {
                    stepIs(5.0),
                    parameterSetTo("k", 0.2, Text::tr("set **k** back to 0.2.")),
                    {[](const Timeline &run) {
                         return isBetweenFrames(run) && !(footFromCentre(run) < 1000.0);
                     },
                     Text::tr("play on. The foot is %1 px away."), footFromCentre, 0},
                },
            .hint = Text::tr("Above the picture, press **Step**, type 5 into the field **Other**, and press "
                             "**Enter**. Then press **Space**."),
        },
        {
            .text = Text::tr(
                "With steps of 1 frame, go to frame 0, set **k** to 0.02 and play to frame 100. A slow swing "
                "forgives a big step."),
            .conditions =
                {
                    parameterSetTo("k", 0.02),
                    {[](const Timeline &run) { return run.script().values["k"] <= 0.025; },
                     Text::tr("set **k** at frame 0: press **Home**.")},
                    oneFrameSteps(),
                    playedTo(100),
                },
            .hint = Text::tr(
                "Choose **1 frame** as step. Press **Home**, type 0.02 beside **k**, press **Space**, "
                "and wait four seconds."),
        },
    };
}

std::vector<Try> energyTries(const Exact &exact)
{
    return {
        {
            .text = Text::tr(
                "Choose **Explicit Euler** as method, and play until there is twice the energy: a drift of "
                "100 %."),
            .conditions = {runsMethod("explicit_euler"), driftAtLeast(exact, 100.0)},
            .hint =
                Text::tr("Above the picture, press **Method** and choose **Explicit Euler**. Press **Space** "
                         "and watch the drift above the parameters."),
        },
        {
            .text = Text::tr(
                "Give it steps of **1/8 frame**. Does a small step save it? Wait for a drift of 10 %."),
            .conditions =
                {
                    stepIs(0.125),
                    runsMethod("explicit_euler", Text::tr("choose **Explicit Euler** as method.")),
                    driftAtLeast(exact, 10.0),
                },
            .hint =
                Text::tr("Choose **Explicit Euler** as method and **1/8 frame** as step. Press **Space** and "
                         "wait."),
            .answer =
                Text::tr("No. The energy grows more slowly, but it still grows, and never stops growing."),
        },
        {
            .text = Text::tr(
                "Choose **Velocity Verlet** with steps of 1 frame. Play 200 frames: the drift stays within "
                "half a percent."),
            .conditions = {runsMethod("velocity_verlet"), oneFrameSteps(), playedTo(200)},
            .hint =
                Text::tr("Choose **Velocity Verlet** as method and **1 frame** as step. Press **Space**, and "
                         "stop after frame 200."),
        },
    };
}

std::vector<Try> halveTries(const Exact &exact, const Values &defaultValues)
{
    return {
        {
            .text = Text::tr(
                "**Semi-implicit Euler**: go to frame 60 with steps of 1/16 frame. Is it half as far "
                "off as with 1/8?"),
            .conditions =
                toFrame60By("semi_implicit_euler", Text::tr("choose **Semi-implicit Euler** as method.")),
            .hint = Text::tr(
                "Choose **1/8 frame** as step, type 60 into the frame counter, and read how far off it "
                "is. Do the same with **1/16 frame**."),
            .answer = Text::tr("Nearly: 0.21 px instead of 0.44 px. Its order is 1."),
        },
        {
            .text = Text::tr("**Midpoint**, the same two steps: a quarter?"),
            .conditions = toFrame60By("midpoint", Text::tr("choose **Midpoint** as method.")),
            .hint =
                Text::tr("Choose **Midpoint** as method, then **1/8** and **1/16 frame** as step, and go to "
                         "frame 60 each time."),
            .answer = Text::tr("Yes: 0.21 px instead of 0.84 px. Its order is 2."),
        },
        {
            .text = Text::tr("**Runge–Kutta 4**, the same two steps: a sixteenth?"),
            .conditions = toFrame60By("rk4", Text::tr("choose **Runge–Kutta 4** as method.")),
            .hint = Text::tr(
                "Choose **Runge–Kutta 4** as method, then **1/8** and **1/16 frame** as step, and go to "
                "frame 60 each time."),
            .answer = Text::tr("Yes: 0.00003 px instead of 0.0005 px. Its order is 4."),
        },
        {
            .text = Text::tr(
                "Be less than 0.01 px off at frame 60, with at most 16 computations a frame. (Any method; "
                "change nothing else.)"),
            .conditions =
                {
                    {[](const Timeline &run) {
                        return !usesMethod(run, "semi_implicit_euler") || stepLength(run) != 1.0;
                    }},
                    unchanged(defaultValues),
                    exactlyAt(60),
                    atMost(16.0, averageForceEvaluations,
                           Text::tr("choose something cheaper. This needs %1 computations a frame."), 0),
                    errorBelow(exact, 0.01, 3),
                },
            .hint =
                Text::tr("Runge–Kutta 4 computes four times in a step. In steps of 1/4 frame that is 16 in a "
                         "frame. Go to frame 60."),
        },
    };
}

std::vector<Try> adaptTries(const Exact &exact, const Values &defaultValues)
{
    return {
        {
            .text = Text::tr(
                "Choose a **tolerance** of 0.1 px or more, and play to frame 150. Less work; how far off?"),
            .conditions =
                {
                    {[](const Timeline &run) {
                        return isAdaptive(run) && run.script().step.tolerance >= 0.1;
                    }},
                    exactlyAt(150),
                },
            .hint = Text::tr(
                "Above the picture, press **Tolerance** and choose **0.1 px**. Then type 150 into the frame "
                "counter."),
            .answer =
                Text::tr("About 23 px. The tolerance is for one step, and the errors of all steps add up."),
        },
        {
            .text = Text::tr(
                "Throw the foot, at 5 px per frame or more, past the middle, within 10 px of it. Watch its "
                "steps get shorter than 1 frame."),
            .conditions =
                {
                    released("foot"),
                    thrownAtLeast(),
                    adaptive(Text::tr("choose **Dormand–Prince 5(4)** as method.")),
                    {[](const Timeline &run) { return distance(run, "foot", "body") <= 10.0; },
                     Text::tr("it has to pass the middle within 10 px. Throw it closer by.")},
                    {[](const Timeline &run) { return lastStep(run.state()) < 1.0; },
                     Text::tr("its step there is %1 frames long: choose a **tolerance** of 0.001 px."),
                     [](const Timeline &run) { return lastStep(run.state()); }},
                },
            .hint = Text::tr(
                "Press **Tolerance** and choose **0.001 px**, then press **Home**. Take the foot and "
                "throw it "
                "so that it just passes the dot in the middle."),
        },
        {
            .text = Text::tr(
                "**Runge–Kutta 4**: find a step with which it is less than 0.2 px off at frame 150. What "
                "does it pay for a frame?"),
            .conditions =
                {
                    runsMethod("rk4"),
                    unchanged(defaultValues),
                    exactlyAt(150),
                    errorBelow(exact, 0.2, 2),
                },
            .hint = Text::tr(
                "Choose **Runge–Kutta 4** as method and **1/4 frame** as step, type 150 into the frame "
                "counter, and read how far off it is."),
            .answer = Text::tr("16 computations of all forces: four for each step of 1/4 frame. Far out it "
                               "would not need them."),
        },
    };
}

std::vector<Try> bounceTries(const Exact &exact, const Values &defaultValues)
{
    return {
        {
            .text =
                Text::tr("Halve the step of **Runge–Kutta 4** until it is 1/8 frame, and play to frame 200. "
                         "Order 4, or 1?"),
            .conditions =
                {
                    stepIs(0.125),
                    runsMethod("rk4", Text::tr("choose **Runge–Kutta 4** as method.")),
                    playedTo(200),
                },
            .hint = Text::tr(
                "Choose **1/8 frame** as step, type 200 into the frame counter, and read how far off it "
                "is."),
            .answer = Text::tr("Order 1: from 1/4 frame to 1/8 frame, the error falls from 24 to 15 px, not "
                               "to a sixteenth."),
        },
        {
            .text = Text::tr("Choose **Dormand–Prince 5(4)**, and play to frame 200. How far off now?"),
            .conditions = {adaptive(), unchanged(defaultValues), exactlyAt(200), errorBelow(exact, 1e-6, 7)},
            .hint =
                Text::tr("Choose **Dormand–Prince 5(4)** as method, and type 200 into the frame counter."),
            .answer = Text::tr(
                "By less than a millionth of a pixel: it ends a step at the very moment of each touch."),
        },
        {
            .text = Text::tr("Keep it, go to frame 0 and set **bounce** to 0.5. Wait until the ball has "
                             "stopped bouncing."),
            .conditions =
                {
                    parameterSetTo("bounce", 0.5),
                    adaptive(Text::tr("choose **Dormand–Prince 5(4)** as method.")),
                    {[](const Timeline &run) {
                         return isBetweenFrames(run) && run.state().restingContacts.any();
                     },
                     Text::tr("play on until the ball lies on the floor.")},
                },
            .hint = Text::tr(
                "Keep Dormand–Prince. Press **Home**, type 0.5 beside **Bounce**, press **Space**, and "
                "wait."),
        },
    };
}

std::vector<Try> budgetTries(const Values &defaultValues)
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
            .text = Text::tr("Be less than 1 px off all the way to frame 200, at any price."),
            .conditions = reachedFrame200,
            .budget = Budget{.error = 1.0, .nsPerFrame = noTimeLimit, .frames = 200},
            .hint = Text::tr("Choose **1/16 frame** as step, and play to frame 200."),
        },
        {
            .text = Text::tr(
                "Less than **1 px** off, within **0.5 µs** a frame. The machine checks both at frame 200."),
            .conditions = reachedFrame200,
            .budget = Budget{.error = 1.0, .nsPerFrame = 500.0, .frames = 200},
            .hint = Text::tr(
                "Try **Velocity Verlet** with steps of 1/2 frame, or **Runge–Kutta 4** with steps of "
                "1 frame. Play past frame 200 and let it play on for a moment."),
        },
        {
            .text = Text::tr("Less than **0.1 px** off, within **1 µs** a frame."),
            .conditions = reachedFrame200,
            .budget = Budget{.error = 0.1, .nsPerFrame = 1000.0, .frames = 200},
            .hint = Text::tr(
                "Try **Runge–Kutta 4** with steps of 1/2 frame. Play past frame 200 and let it play on "
                "for a moment."),
        },
    };
}

std::vector<Try> crowdTries()
{
    constexpr std::int64_t frames = 60; ///< frames
    return {
        {
            .text = Text::tr(
                "Set **Creatures** to 20 000 and play on for 60 frames. Does a frame take twice as long as "
                "with 10 000?"),
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["creatures"] >= 20'000.0; }},
                    unchangedFor("creatures", frames),
                },
            .hint = Text::tr(
                "Type 10000 into the field beside **Creatures**, press **Space**, and wait a moment. "
                "Then type 20000, and wait again. The panel Effects (**Ctrl+4**) tells how long a frame "
                "takes."),
            .answer = Text::tr("About twice: each creature costs the same. It is more where the machine’s "
                               "cache no longer holds all of them."),
        },
        {
            .text = Text::tr("Set **Bounce** to 0 and wait until all lie still."),
            .conditions =
                {
                    parameterSetTo("bounce", 0.0),
                    {[](const Timeline &run) {
                         return isBetweenFrames(run) && (run.state().velocity.abs() <= stillness).all() &&
                                isStill(run);
                     },
                     Text::tr("let time run (**Space**) until nothing moves.")},
                },
            .hint = Text::tr(
                "Type 0 into the field beside **Bounce**, press **Space**, and wait. Fewer creatures "
                "are sooner done."),
        },
        {
            .text = Text::tr(
                "Set **Gravity** to 0 and play on for 60 frames. It is left out now: its phase is gone "
                "from the strip below."),
            .conditions = {parameterSetTo("gravity", 0.0), unchangedFor("gravity", frames)},
            .hint =
                Text::tr("Type 0 into the field beside **Gravity**, press **Space**, and wait two seconds."),
        },
    };
}

}
