#include "steps.h"

#include "checks.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

using namespace lessons;

namespace multi_foot {

namespace {

View viewWithLegs(const sim::Scene &scene, const sim::Values &)
{
    return creatureViewWithLegs(scene);
}

Step newStep(const char *id)
{
    Step step = lessons::makeStep("multi_foot", id);
    step.parameters = {stiffness(), damping(0.85), radius()};
    step.view = viewWithLegs;
    return step;
}

}

Step twoFeetStep()
{
    Step step = newStep("two_feet");
    step.readTexts(twoFeetChecks());
    step.scene = two_feet::setUp;
    return step;
}

Step anyNumberStep()
{
    Step step = newStep("any_number");
    step.parameters.push_back(feet(5));
    step.readTexts(anyNumberChecks());
    step.scene = any_number::setUp;
    return step;
}

Step grownFeetStep()
{
    Step step = newStep("grown_feet");
    step.parameters.push_back(feet(5));
    step.readTexts(grownFeetChecks());
    step.scene = grown_feet::setUp;
    return step;
}

}
