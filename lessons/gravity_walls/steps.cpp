#include "steps.h"

#include "checks.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/acting.h"
#include "lessons/api/view/creature_view.h"
#include "scenes.h"
#include "sim/effects/contacts/walls.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

using namespace lessons;

namespace gravity_walls {

namespace {

View roomView(const sim::Scene &scene, const sim::Values &)
{
    View view = creatureViewWithLegs(scene);
    if (const auto *walls = effectOf<sim::Walls>(scene))
        view.room = walls->room();
    return view;
}

Step newStep(const char *id)
{
    Step step = lessons::makeStep("gravity_walls", id);
    step.view = roomView;
    return step;
}

}

Step wallsStep()
{
    Step step = newStep("walls");
    step.addParameters({bounce(), stiffness(), damping(0.85), radius(), feet(5)});
    step.addParameters(room());
    step.readTexts(wallsChecks());
    step.scene = walls::setUp;
    return step;
}

Step gravityStep()
{
    Step step = newStep("gravity");
    step.addParameters({lessons::gravity(), bounce(), stiffness(), damping(0.85), radius(), feet(4)});
    step.addParameters(room());
    step.readTexts(gravityChecks());
    step.scene = gravity::setUp;
    return step;
}

}
