#include "steps.h"

#include "checks.h"
#include "lessons/api/parameters.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

using namespace lessons;

namespace two_body {

namespace {

Step newStep(const char *id)
{
    Step step = lessons::makeStep("two_body", id);
    step.parameters = {stiffness(), damping(), radius()};
    return step;
}

}

Step mutualStep()
{
    Step step = newStep("mutual");
    step.readTexts(mutualChecks());
    step.scene = mutual::setUp;
    step.view = [](const sim::Scene &scene, const sim::Values &) { return mutual::look(scene); };
    return step;
}

Step legLineStep()
{
    Step step = newStep("leg_line");
    step.readTexts(legLineChecks());
    step.scene = leg_line::setUp;
    step.view = [](const sim::Scene &scene, const sim::Values &) { return leg_line::look(scene); };
    return step;
}

}
