#pragma once

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
#include "tests/sim/support/counting.h"
#include "tests/sim/support/support.h"

/// Scenes and helpers for the suites of sleeping runs.
namespace sleep_scenes {

using namespace sim;
using std::make_shared;
using support::CountingForce;

inline constexpr std::size_t budget = std::size_t{1} << 24;

/// Returns a point on a spring to a position that depends on the parameter k, and a body on a spring to that
/// point.
inline Scene homing(const Values &values)
{
    Scene scene = scenes::creature(1);
    scene.start.place(0, {100.0, 90.0});
    scene.effects = {make_shared<PointSpring>(0, Vec2{260.0 + 100.0 * values["k"], 200.0}, 0.2),
                     make_shared<RadialSpring>(scenes::legs(1), values["k"], 50.0),
                     make_shared<Damping>(0.5)};
    return scene;
}

/// Returns a scene that rests until it gets input. It has a leg that a key sets in motion, a clock that
/// follows the target, and a point that follows the pointer.
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

/// Returns a tree in wind with random turbulence.
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

/// Returns the first frame at which `track` sleeps, or -1 if it does not sleep before frame `latest`.
inline std::int64_t sleepsFrom(Track &track, std::int64_t latest = 20'000)
{
    for (std::int64_t frame = 0; frame < latest; frame += track.framesPerOutput()) {
        track.seek({frame, 0});
        if (track.sleep())
            return frame;
    }
    return -1;
}

/// Compares a run that may sleep with one that never does, over `frames` frames. Returns the first
/// difference, or an empty string.
inline std::string sleepDiffers(const Script &script, std::int64_t frames)
{
    Track sleeper(script, budget), reference(script, budget, Sleeping::never);
    for (std::int64_t frame = 0; frame <= frames; frame += sleeper.framesPerOutput()) {
        sleeper.seek({frame, 0});
        reference.seek({frame, 0});
        if (reference.sleep())
            return "the run that must not sleep sleeps";
        const std::string found = support::difference(sleeper.state(), reference.state());
        if (!found.empty() || !sameBits(sleeper.state(), reference.state()))
            return "frame " + std::to_string(frame) + ": " + found;
    }
    return {};
}

}
