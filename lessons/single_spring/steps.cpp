#include "steps.h"

#include "checks.h"
#include "lessons/api/parameters.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

using namespace lessons;

namespace single_spring {

namespace {

/// Returns a step with the settings that all steps of this lesson share. `id` is also the marker of its
/// set-up function.
Step newStep(const char *id)
{
    Step step = lessons::makeStep("single_spring", id);
    step.parameters = {stiffness(), damping()};
    step.view = discsAndSprings;
    return step;
}

}

Step dragStep()
{
    Step step = newStep("drag");
    step.addParameters(centre());
    for (Parameter &parameter : step.parameters) {
        if (parameter.id != QStringLiteral("damp")) // nothing pulls yet: shown from the next step on
            parameter.effects = {QStringLiteral("point_spring")};
    }
    step.readTexts(dragChecks());
    step.scene = drag::setUp;
    step.overlays = inactivePull;
    return step;
}

Step fixedCentreStep()
{
    Step step = newStep("fixed_centre");
    step.addParameters(centre());
    step.readTexts(fixedCentreChecks());
    step.scene = fixed_centre::setUp;
    step.overlays = centreCross;
    return step;
}

Step movingBodyStep()
{
    Step step = newStep("moving_body");
    step.readTexts(movingBodyChecks());
    step.scene = moving_body::setUp;
    return step;
}

Step offsetStep()
{
    Step step = newStep("offset");
    step.addParameters({lessons::offset()});
    step.readTexts(offsetChecks());
    step.scene = offset::setUp;
    step.overlays = offsetCross;
    return step;
}

Step radialStep()
{
    Step step = newStep("radial");
    step.addParameters({lessons::radius()});
    step.readTexts(radialChecks());
    step.scene = radial::setUp;
    step.view = discsWithAngle;
    step.overlays = ringAndAngle;
    return step;
}

}
