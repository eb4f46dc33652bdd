#pragma once

#include "app/model/catalog/lesson_library.h"
#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/pointer.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"

/// Shared by the suites of the ledger of effects: small lessons.
namespace effects_support {

/// A spring to the body that says what it ties.
class TiedSpring : public sim::BodySpring
{
public:
    using BodySpring::BodySpring;
    void addCouplings(std::vector<sim::Coupling> &into) const override { into.emplace_back(0, 1); }
};

/// Gravity that is left out where it is 0.
class RareGravity : public sim::Gravity
{
public:
    explicit RareGravity(double gravity) : Gravity(gravity), m_gravity(gravity) {}
    bool isIdle() const override { return m_gravity == 0.0; }

private:
    double m_gravity;
};

inline lessons::Step tiedStep()
{
    lessons::Step step;
    step.id = "tied";
    step.title = "A leg";
    lessons::Parameter gravity = lessons::gravity();
    gravity.defaultValue = 0.0;
    step.parameters = {lessons::stiffness(), lessons::damping(), gravity};
    step.scene = [](const sim::Values &values) {
        sim::Scene scene = scenes::pair();
        scene.start.place(0, {300, 210});
        scenes::add<TiedSpring>(scene, std::vector<sim::Link>{{0, 1}}, values["k"]);
        scenes::add<RareGravity>(scene, values["gravity"]);
        scenes::add<sim::Damping>(scene, values["damp"]);
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) {
        return lessons::creatureViewWithLegs(scene);
    };
    return step;
}

/// Nothing but a pointer moves anything here.
inline lessons::Step puppetStep()
{
    lessons::Step step;
    step.id = "puppet";
    step.title = "A puppet";
    step.scene = [](const sim::Values &) {
        sim::Scene scene = scenes::singleFoot();
        scene.groups.front().motion = sim::Motion::prescribed;
        scenes::add<sim::CarriedByPointer>(scene, 0);
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    return step;
}

inline lessons::Step walledStep()
{
    lessons::Step step = tiedStep();
    step.id = "walled";
    step.scene = [](const sim::Values &) {
        sim::Scene scene = scenes::pair();
        scenes::add<sim::Walls>(scene, sim::Room{20, 520, 380, 1}, scenes::halfWidths(scene));
        return scene;
    };
    return step;
}

inline app::LessonLibrary legLibrary()
{
    app::LessonLibrary library;
    library.lessons.push_back({"legs", 1, "Legs", "The first.", {tiedStep(), puppetStep()}});
    library.lessons.push_back({"rooms", 2, "Rooms", "The second.", {walledStep()}});
    return library;
}

}
