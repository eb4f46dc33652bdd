#include "tries.h"

#include "lessons/api/checks.h"
#include "lessons/api/hand.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;
using sim::Values;

namespace accuracy {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Accuracy)
};

/// The length of the method's steps in frames; infinite for a method that chooses its own.
double stepOf(const Timeline &run)
{
    const sim::StepSize &step = run.script().step;
    return step.adaptive() ? std::numeric_limits<double>::infinity() : step.h;
}

bool isAdaptive(const Timeline &run)
{
    return run.script().step.adaptive();
}

/// Whether the cursor stands between two frames, at `frame` or later.
bool hasCome(const Timeline &run, std::int64_t frame)
{
    return run.at().phase == 0 && run.at().frame >= frame;
}

/// The same at exactly that frame.
bool standsAt(const Timeline &run, std::int64_t frame)
{
    return run.at() == sim::Cursor{frame, 0};
}

/// Whether nothing but method and step was changed.
bool isAsGiven(const Timeline &run, const Values &presets)
{
    const sim::Script &script = run.script();
    return script.values == presets && script.input.empty() && script.bodies.empty() &&
           script.effectsOff.empty();
}

/// px at the cursor, between two frames.
double offBy(const Exact &exact, const Timeline &run)
{
    return exact->distance(run.script(), run.now(), run.at().frame);
}

/// Percent at the cursor, between two frames.
double driftOf(const Exact &exact, const Timeline &run)
{
    return energyDrift(*exact, run.script(), run.track().shown().scene, run.now(), run.values());
}

/// A try that is done when the method `id` with steps of at most `h` frames comes to frame 60.
Try orderTry(const QString &text, const char *id, double h)
{
    return {text, [id, h](const Timeline &run) {
                return usesMethod(run, id) && stepOf(run) <= h && standsAt(run, 60);
            }};
}

/// How often a frame has computed all forces, on the average from the start to the cursor.
double averageComputations(const Timeline &run)
{
    if (isAdaptive(run))
        return run.now().turns() / static_cast<double>(run.at().frame);
    return computations(run.script(), run.now(), nullptr);
}

}

std::vector<Try> bigStepTries(const Exact &exact)
{
    return {
        {Text::tr("Choose **1/8 frame** as step, and play to frame 100. How far is it off now?"),
         [](const Timeline &run) { return stepOf(run) <= 0.125 && hasCome(run, 100); }},
        {Text::tr("Choose **2 frames**. Wait until the foot is more than 100 px off."),
         [exact](const Timeline &run) {
             return stepOf(run) == 2.0 && hasCome(run, 1) && offBy(exact, run) > 100.0;
         }},
        {Text::tr(
             "With steps of 1 frame, go to frame 0, set **k** to 0.02 and play to frame 100. A slow swing "
             "forgives a big step."),
         [](const Timeline &run) {
             return stepOf(run) == 1.0 && run.script().values["k"] <= 0.025 && isSetTo(run, "k", 0.02) &&
                    hasCome(run, 100);
         }},
        {Text::tr("Type **5 frames** as step. Now k h² is 5, more than 4: each swing throws it farther out."),
         [](const Timeline &run) {
             return stepOf(run) == 5.0 && hasCome(run, 5) &&
                    !(sim::length(placeOf(run, "foot") - sim::Vec2{270.0, 200.0}) < 1000.0);
         }},
    };
}

std::vector<Try> energyTries(const Exact &exact)
{
    return {
        {Text::tr("Choose **Explicit Euler** as method, and play until there is twice the energy: a drift of "
                  "100 %."),
         [exact](const Timeline &run) {
             return usesMethod(run, "explicit_euler") && hasCome(run, 1) && driftOf(exact, run) >= 100.0;
         }},
        {Text::tr("Give it steps of **1/8 frame**. Does a small step save it? Wait for a drift of 10 %."),
         [exact](const Timeline &run) {
             return usesMethod(run, "explicit_euler") && stepOf(run) <= 0.125 && hasCome(run, 1) &&
                    driftOf(exact, run) >= 10.0;
         }},
        {Text::tr("Choose **Velocity Verlet** with steps of 1 frame. Play 200 frames: the drift stays within "
                  "half a percent."),
         [exact](const Timeline &run) {
             return usesMethod(run, "velocity_verlet") && stepOf(run) == 1.0 && hasCome(run, 200) &&
                    std::abs(driftOf(exact, run)) <= 0.51;
         }},
    };
}

std::vector<Try> halveTries(const Exact &exact, const Values &presets)
{
    return {
        orderTry(
            Text::tr("**Semi-implicit Euler**: play to frame 60 with steps of 1/8 frame, then with 1/16. "
                     "Half as far off?"),
            "semi_implicit_euler", 1.0 / 16),
        orderTry(Text::tr("**Midpoint**, the same two steps: a quarter?"), "midpoint", 1.0 / 16),
        orderTry(Text::tr("**Runge–Kutta 4**, the same two steps: a sixteenth?"), "rk4", 1.0 / 16),
        {Text::tr("Be less than 0.01 px off at frame 60, with at most 16 computations a frame. (Any method; "
                  "change nothing else.)"),
         [exact, presets](const Timeline &run) {
             return isAsGiven(run, presets) && standsAt(run, 60) && averageComputations(run) <= 16.0 &&
                    offBy(exact, run) < 0.01;
         }},
    };
}

std::vector<Try> adaptTries(const Exact &exact, const Values &presets)
{
    return {
        {Text::tr("Choose a **tolerance** of 0.1 px or more, and play to frame 150. Less work; how far off?"),
         [](const Timeline &run) {
             return isAdaptive(run) && run.script().step.tolerance >= 0.1 && hasCome(run, 150);
         }},
        {Text::tr(
             "Throw the foot past the middle, within 10 px of it. Watch its steps get shorter than 1 frame."),
         [](const Timeline &run) {
             return isAdaptive(run) && wasThrown(run, "foot") && heldBody(run).empty() &&
                    distance(run, "foot", "body") <= 10.0 && lastStep(run.now()) < 1.0;
         }},
        {Text::tr(
             "**Runge–Kutta 4**: find a step with which it is less than 0.2 px off at frame 150. What does "
             "it pay for a frame?"),
         [exact, presets](const Timeline &run) {
             return isAsGiven(run, presets) && usesMethod(run, "rk4") && standsAt(run, 150) &&
                    offBy(exact, run) < 0.2;
         }},
    };
}

std::vector<Try> bounceTries(const Exact &exact, const Values &presets)
{
    return {
        {Text::tr("Halve the step of **Runge–Kutta 4** until it is 1/8 frame, and play to frame 200. "
                  "Order 4, or 1?"),
         [](const Timeline &run) {
             return usesMethod(run, "rk4") && stepOf(run) <= 0.125 && hasCome(run, 200);
         }},
        {Text::tr("Choose **Dormand–Prince 5(4)**, and play to frame 200. How far off now?"),
         [exact, presets](const Timeline &run) {
             return isAdaptive(run) && isAsGiven(run, presets) && standsAt(run, 200) &&
                    offBy(exact, run) < 1e-6;
         }},
        {Text::tr(
             "Keep it, go to frame 0 and set **bounce** to 0.5. Wait until the ball has stopped bouncing."),
         [](const Timeline &run) {
             return isAdaptive(run) && isSetTo(run, "bounce", 0.5) && hasCome(run, 1) &&
                    run.now().resting.any();
         }},
    };
}

std::vector<Try> budgetTries(const Values &presets)
{
    const auto came = [presets](const Timeline &run) {
        const bool asAtFirst = usesMethod(run, "semi_implicit_euler") && stepOf(run) == 1.0;
        return isAsGiven(run, presets) && !asAtFirst && hasCome(run, 200);
    };
    constexpr double anyTime = std::numeric_limits<double>::infinity();
    return {
        {Text::tr("Be less than 1 px off all the way to frame 200, at any price."), came,
         Budget{1.0, anyTime, 200}},
        {Text::tr("Less than **1 px** off, within **0.5 µs** a frame. The machine checks both at frame 200."),
         came, Budget{1.0, 500.0, 200}},
        {Text::tr("Less than **0.1 px** off, within **1 µs** a frame."), came, Budget{0.1, 1000.0, 200}},
    };
}

std::vector<Try> crowdTries()
{
    constexpr std::int64_t someTime = 60; ///< frames
    return {
        {Text::tr("Set **Creatures** to 10 000 and play on for 60 frames. Then to 20 000: does it take twice "
                  "as long?"),
         [](const Timeline &run) {
             return run.values()["creatures"] >= 20'000.0 && framesSinceSet(run, "creatures") >= someTime;
         }},
        {Text::tr(
             "Set **Gravity** to 0 and play on for 60 frames. It is left out now; look for its line in the "
             "code."),
         [](const Timeline &run) {
             return run.values()["gravity"] == 0.0 && framesSinceSet(run, "gravity") >= someTime;
         }},
        {Text::tr("Set **Bounce** to 0 and wait until all lie still."),
         [](const Timeline &run) {
             const bool mayBe = isSetTo(run, "bounce", 0.0) && hasCome(run, 1);
             return mayBe && (run.now().velocity.abs() <= stillness).all() && isStill(run);
         }},
    };
}

}
