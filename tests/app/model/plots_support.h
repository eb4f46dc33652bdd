#pragma once

#include "app/model/session/session.h"
#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/methods/methods.h"
#include "tests/app/support/two_lessons.h"

/// Shared by the suites of plots: one lesson whose steps have closed forms.
namespace plots_support {

constexpr double gravity = 0.5;    ///< px/frame^2
constexpr double stiffness = 0.04; ///< 1/frame^2
constexpr double fallFrom = 10.0;  ///< px down, where `fall` begins
constexpr double pulledBy = 30.0;  ///< px from the place that pulls the foot of `swing`

/// One step: a lone "foot" and what `addEffects` adds.
inline lessons::Step loneStep(const char *id, sim::Vec2 start, const char *method,
                              std::function<void(sim::Scene &, const sim::Values &)> addEffects)
{
    lessons::Step step;
    step.id = step.title = id;
    step.method = method;
    step.parameters = {lessons::stiffness(stiffness)};
    step.scene = [start, addEffects](const sim::Values &values) {
        sim::Scene scene = scenes::singleFoot();
        scene.start.place(0, start);
        addEffects(scene, values);
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    return step;
}

/// "fall": free fall, undamped. "swing": an undamped spring. "pair": foot and body, damped, as in the lessons. "puppet": the
/// same, but nothing has inertia.
inline app::LessonLibrary library()
{
    const auto swing = [](sim::Scene &scene, const sim::Values &values) {
        scenes::add<sim::PointSpring>(scene, 0, sim::Vec2{270, 200}, values["k"]);
    };
    const auto fall = [](sim::Scene &scene, const sim::Values &) {
        scenes::add<sim::Gravity>(scene, gravity);
    };
    lessons::Step pair = loneStep("pair", {}, "published", [](sim::Scene &, const sim::Values &) {});
    pair.scene = [](const sim::Values &values) {
        sim::Scene scene = scenes::pair();
        scene.start.place(0, {300, 210});
        scenes::add<sim::PointSpring>(scene, 0, sim::Vec2{270, 200}, values["k"]);
        scenes::add<sim::Damping>(scene, 0.95);
        return scene;
    };
    lessons::Step puppet = tests::puppetOf(pair);
    puppet.title = puppet.id;
    app::LessonLibrary library;
    library.lessons.push_back(
        {"plots",
         1,
         "Plots",
         "Closed forms.",
         {pair, loneStep("fall", {100, fallFrom}, "semi_implicit_euler", fall),
          loneStep("swing", {270, 200 + pulledBy}, "implicit_midpoint", swing), puppet}});
    return library;
}

}
