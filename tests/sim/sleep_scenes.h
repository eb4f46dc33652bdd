#pragma once

#include "counting.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/drivers/motor.h"
#include "sim/effects/drivers/pointer.h"
#include "sim/effects/drivers/steering.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/methods/methods.h"
#include "sim/run/sleeping/sleep.h"
#include "sim/run/sleeping/sleep_blocker.h"
#include "sim/scenes/trees.h"
#include "support.h"

/// What suites of sleeping runs share.
namespace sleep_bench {

using namespace sim;
using std::make_shared;
using support::Counting;

inline constexpr std::size_t budget = std::size_t{1} << 24;

/// A point that a spring pulls home, to a place that a parameter decides, and one that hangs on it.
inline Scene homing(const Values &values)
{
    Scene scene = scenes::creature(1);
    scene.start.place(0, {100.0, 90.0});
    scene.effects = {make_shared<PointSpring>(0, Vec2{260.0 + 100.0 * values["k"], 200.0}, 0.2),
                     make_shared<RadialSpring>(scenes::legs(1), values["k"], 50.0),
                     make_shared<Damping>(0.5)};
    return scene;
}

/// Legs that a key may set in motion, a point that follows the target, and one that follows the pointer.
inline Scene waiting(const Values &)
{
    Scene scene = scenes::creature(3);
    scene.start.gait.setConstant(1, 0.3);
    scene.start.gaitSpeed.setConstant(1, 0.0);
    scene.start.input.target = {100.0, 100.0};
    const LegRule rule{0.2, 50.0, 50.0, Aim::swing, Reaction::none};
    scene.effects = {make_shared<CarriedByPointer>(2),
                     make_shared<Steering>(0, 3, SteeringLimits{}),
                     make_shared<LegSpring>(std::vector<Leg>{{0, 3, 0.3, 0}}, rule),
                     make_shared<Motor>(1, 0.9, 0.25),
                     make_shared<PointSpring>(3, Vec2{200.0, 200.0}, 0.2),
                     make_shared<Damping>(0.5),
                     make_shared<GaitClock>()};
    return scene;
}

/// A tree in wind whose turbulence is random.
inline Scene windy(const Values &)
{
    const TreePtr tree = make_shared<const Tree>(scenes::bush());
    Scene scene = scenes::branchesOf(*tree);
    scene.effects = {make_shared<TreeWind>(tree, TreeFormula::corrected, Resistance{}, Turbulence{20.0, 7})};
    return scene;
}

inline Script scriptOf(Scene (*build)(const Values &), const std::string &method = "semi_implicit_euler",
                       double h = 1.0)
{
    Values values;
    values.set("k", 0.1);
    return support::script(support::Sample{{}, build, values}, method, h);
}

/// The first frame at which `track` is asleep.
inline std::int64_t sleepsFrom(Track &track, std::int64_t latest = 20'000)
{
    for (std::int64_t frame = 0; frame < latest; frame += track.framesPerOutput()) {
        track.seek({frame, 0});
        if (track.sleep())
            return frame;
    }
    return -1;
}

/// What differs first between a run that may sleep and one that never does, in `frames` frames.
inline std::string sleepDiffers(const Script &script, std::int64_t frames)
{
    Track sleeper(script, budget), waker(script, budget, Sleeping::never);
    for (std::int64_t frame = 0; frame <= frames; frame += sleeper.framesPerOutput()) {
        sleeper.seek({frame, 0});
        waker.seek({frame, 0});
        if (waker.sleep())
            return "the waker sleeps";
        const std::string what = support::difference(sleeper.state(), waker.state());
        if (!what.empty() || !sameBits(sleeper.state(), waker.state()))
            return "frame " + std::to_string(frame) + ": " + what;
    }
    return {};
}

}
