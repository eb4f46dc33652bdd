#include "tries.h"

#include "cases.h"
#include "lessons/api/checks.h"
#include "lessons/api/hand.h"
#include "marks.h"
#include "scenes.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;

namespace hard_cases {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

/// Whether the run goes by steps of `h` frames that something stiff can be too much for.
bool hasLimit(const Timeline &run)
{
    return run.script().method->stepLimit() == sim::StepLimit::stiffness;
}

double stepOf(const Timeline &run)
{
    return run.script().step.adaptive() ? 0.0 : run.script().step.h;
}

/// Whether the cursor stands between two frames, at `frame` or later, in a run that goes on.
bool hasCome(const Timeline &run, std::int64_t frame)
{
    return run.at().phase == 0 && run.at().frame >= frame && !run.stop();
}

/// Whether the run began with that value, and still has it.
bool beganWith(const Timeline &run, const char *id, double value)
{
    return std::abs(run.script().values[id] - value) <= 0.005 && isSetTo(run, id, value);
}

/// px: how far the worst leg is from the length that its spring wants.
double worstLeg(const Timeline &run, double length)
{
    const sim::State &state = run.now();
    const int body = state.points() - 1;
    double worst = 0.0;
    for (int i = 0; i < body; ++i)
        worst = std::max(worst, std::abs(sim::length(state.at(i) - state.at(body)) - length));
    return worst;
}

/// px: how far the two feet are from each other that are nearest.
double nearestFeet(const Timeline &run)
{
    const sim::State &state = run.now();
    const int body = state.points() - 1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < body; ++i) {
        for (int j = 0; j < i; ++j)
            nearest = std::min(nearest, sim::length(state.at(i) - state.at(j)));
    }
    return nearest;
}

/// px: how far the foot of a lone spring swings out, of the place and speed it has now.
double swing(const Timeline &run)
{
    const sim::State &state = run.now();
    const double k = run.values()["k"];
    return std::sqrt(std::pow(sim::length(state.at(0) - centre), 2) +
                     std::pow(sim::length(state.speed(0)), 2) / k);
}

bool isCase(const Timeline &run, const char *id)
{
    return run.values().whole("case") == numberOf(id) && isAsTold(run.script());
}

}

std::vector<Try> limitTries()
{
    return {
        {Text::tr("Choose **1/2 frame** as step, and play to frame 100. It swings, hardly farther than the "
                  "crosses."),
         [](const Timeline &run) {
             return hasLimit(run) && stepOf(run) <= 0.5 && stepOf(run) > 0.0 && beganWith(run, "k", 4.01) &&
                    hasCome(run, 100);
         }},
        {Text::tr(
             "With steps of 1 frame, go to frame 0 and set **k** to 3.9. Play to frame 100: six times as "
             "far, and it always comes back."),
         [](const Timeline &run) {
             return hasLimit(run) && stepOf(run) == 1.0 && beganWith(run, "k", 3.9) && hasCome(run, 100);
         }},
        {Text::tr("At k = 4.01, go to frame 0 and set **damp** to 0.9. The limit is 4.22 now: wait until it "
                  "rests."),
         [](const Timeline &run) {
             return hasLimit(run) && stepOf(run) == 1.0 && beganWith(run, "k", 4.01) &&
                    beganWith(run, "damp", 0.9) && hasCome(run, 1) && isStill(run);
         }},
    };
}

std::vector<Try> runawayTries()
{
    return {
        {Text::tr("Choose **Semi-implicit Euler** as method, and play to frame 200. Where is the middle?"),
         [](const Timeline &run) {
             return usesMethod(run, "semi_implicit_euler") && hasCome(run, 200) &&
                    sim::length(middle(run) - sim::Vec2{300.0, 230.0}) < 1e-6;
         }},
        {Text::tr(
             "With **Published** and steps of 1 frame, go to frame 0 and set **k** to 0.2. Wait until it "
             "rests: 157 px from where it belongs."),
         [](const Timeline &run) {
             return usesMethod(run, "published") && stepOf(run) == 1.0 && beganWith(run, "k", 0.2) &&
                    hasCome(run, 1) && isStill(run);
         }},
        {Text::tr(
             "**Published** at k = 0.3, with steps of **1/4 frame**: wait until it rests. Less wrong, and "
             "never right."),
         [](const Timeline &run) {
             return usesMethod(run, "published") && stepOf(run) <= 0.25 && beganWith(run, "k", 0.3) &&
                    hasCome(run, 1) && isStill(run);
         }},
    };
}

std::vector<Try> manyFeetTries()
{
    const auto calm = [](const Timeline &run, double least) {
        return hasLimit(run) && run.script().values["feet"] >= least && hasCome(run, 60) && isStill(run) &&
               worstLeg(run, run.values()["radius"]) < 1.0;
    };
    return {
        {Text::tr("With steps of 1 frame, go to frame 0 and set **feet** to 38. Wait until it rests."),
         [calm](const Timeline &run) {
             return stepOf(run) == 1.0 && beganWith(run, "feet", 38) && beganWith(run, "k", 0.2) &&
                    calm(run, 38);
         }},
        {Text::tr("Sixty feet at rest with steps of **1/2 frame**."),
         [calm](const Timeline &run) { return stepOf(run) <= 0.5 && stepOf(run) > 0.0 && calm(run, 60); }},
        {Text::tr("Sixty feet at rest with steps of 1 frame: how soft must the springs be? (Go to frame 0 "
                  "first.)"),
         [calm](const Timeline &run) {
             return stepOf(run) == 1.0 && run.script().values["k"] < 0.2 &&
                    run.script().values["damp"] >= 0.85 && calm(run, 60);
         }},
    };
}

std::vector<Try> onePlaceTries()
{
    const auto apart = [](const Timeline &run) { return nearestFeet(run) > 10.0; };
    return {
        {Text::tr("Choose **Semi-implicit Euler**, and play from frame 0 to 60: five feet, all apart."),
         [apart](const Timeline &run) {
             return !usesMethod(run, "published") && run.script().input.empty() && hasCome(run, 60) &&
                    apart(run);
         }},
        {Text::tr(
             "**Published**: drag one foot up, out of the line, let go, and wait until it rests. Did the "
             "others follow one by one, or as one?"),
         [](const Timeline &run) {
             const std::optional<Carry> carry = lastLetGo(run);
             return usesMethod(run, "published") && carry && carry->reach() > 20.0 && hasCome(run, 1) &&
                    framesWithoutHand(run) >= 20 && isStill(run);
         }},
        {Text::tr("With any other method and all feet apart, set **radius** to 0: all fall into one place. "
                  "After 60 frames set it to 50 again. Do they part?"),
         [apart](const Timeline &run) {
             const std::vector<sim::Event> &input = run.script().input;
             const bool collapsed = std::any_of(input.begin(), input.end(), [&](const sim::Event &event) {
                 const auto *set = std::get_if<sim::Set>(&event.what);
                 return set && set->parameter == "radius" && set->value == 0.0 &&
                        event.frame <= run.at().frame - 100;
             });
             return !usesMethod(run, "published") && collapsed && isSetTo(run, "radius", 50.0) &&
                    framesSinceSet(run, "radius") >= 40 && hasCome(run, 1) && apart(run);
         }},
    };
}

std::vector<Try> stiffTries()
{
    return {
        {Text::tr("**Semi-implicit Euler**: find a step with which the stiff legs come to rest."),
         [](const Timeline &run) {
             return hasLimit(run) && stepOf(run) > 0.0 && run.script().values["k"] >= 1000.0 &&
                    hasCome(run, 20) && isStill(run) && worstLeg(run, 50.0) < 0.1;
         }},
        {Text::tr("**Backward Euler**, steps of 1 frame: go to frame 0, type 1000000 as **k**, and play "
                  "30 frames."),
         [](const Timeline &run) {
             return usesMethod(run, "backward_euler") && stepOf(run) == 1.0 &&
                    run.script().values["k"] >= 1e6 && hasCome(run, 30) && worstLeg(run, 50.0) < 0.01;
         }},
        {Text::tr("The price: **Backward Euler** with **k** 0.2 and **damp** 1, from frame 0. Nothing slows "
                  "the legs. Wait until they have stopped swinging."),
         [](const Timeline &run) {
             return usesMethod(run, "backward_euler") && stepOf(run) == 1.0 && beganWith(run, "damp", 1.0) &&
                    beganWith(run, "k", 0.2) && hasCome(run, 60) && worstLeg(run, 50.0) < 0.5;
         }},
    };
}

std::vector<Try> contradictionTries()
{
    return {
        {Text::tr("Springs, steps of 1 frame: go to frame 0 and set **k** to 1. They share the error: wait "
                  "until they rest."),
         [](const Timeline &run) {
             return isSetTo(run, "made_of", 0.0) && stepOf(run) == 1.0 && beganWith(run, "k", 1.0) &&
                    beganWith(run, "longest", 200.0) && hasCome(run, 30) && isStill(run);
         }},
        {Text::tr("Choose **sticks**, and wait until they rest. Which of them has its length?"),
         [](const Timeline &run) {
             return isSetTo(run, "made_of", 1.0) && beganWith(run, "longest", 200.0) && hasCome(run, 30) &&
                    isStill(run);
         }},
        {Text::tr("Sticks: make **longest** so short that there is such a triangle, and all three are right "
                  "to 0.1 px."),
         [](const Timeline &run) {
             const auto off = [&](const char *a, const char *b, double length) {
                 return std::abs(distance(run, a, b) - length);
             };
             return isSetTo(run, "made_of", 1.0) && hasCome(run, 20) &&
                    std::max({off("p0", "p1", shortStick), off("p1", "p2", shortStick),
                              off("p0", "p2", run.values()["longest"])}) < 0.1;
         }},
    };
}

std::vector<Try> longRunTries()
{
    const auto whole = [](const Timeline &run, std::int64_t frame) {
        return run.script().step.h <= 1.0 && beganWith(run, "k", 0.5) && beganWith(run, "damp", 1.0) &&
               run.script().input.empty() && hasCome(run, frame);
    };
    return {
        {Text::tr("**Runge–Kutta 4**, steps of 1 frame: go to frame 5000. What is left?"),
         [whole](const Timeline &run) {
             return usesMethod(run, "rk4") && stepOf(run) == 1.0 && whole(run, 5000) && swing(run) < 5.0;
         }},
        {Text::tr("The same with steps of **1/2 frame**: a thirty-second of the loss a frame."),
         [whole](const Timeline &run) {
             return usesMethod(run, "rk4") && stepOf(run) == 0.5 && whole(run, 5000) && swing(run) > 100.0;
         }},
        {Text::tr("**Velocity Verlet**, steps of 1 frame, to frame 20000: it swings as at first."),
         [whole](const Timeline &run) {
             return usesMethod(run, "velocity_verlet") && stepOf(run) == 1.0 && whole(run, 20000) &&
                    swing(run) > 110.0;
         }},
    };
}

std::vector<Try> tortureTries()
{
    return {
        {Text::tr("Case **nearly rigid**: find a method that claims it, and play until it is at rest."),
         [](const Timeline &run) {
             return isCase(run, "stiffness_1e9") && hasCome(run, 10) &&
                    sim::length(run.now().at(0) - centre) <= 1e-6;
         }},
        {Text::tr("Case **torn away**: find a method with which the legs have their length again before "
                  "frame 400. Which is the quickest?"),
         [](const Timeline &run) {
             return isCase(run, "dragged_1e9") && hasCome(run, 30) && run.at().frame < 400 && isStill(run) &&
                    worstLeg(run, 50.0) < 0.01;
         }},
        {Text::tr("Make any case **stop**: find one that a method does not claim, and see who went first."),
         [](const Timeline &run) {
             return run.stop() && run.at().frame == run.stop()->frame && isAsTold(run.script());
         }},
    };
}

}
