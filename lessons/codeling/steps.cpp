#include "steps.h"

#include "checks.h"
#include "parameters.h"
#include "scenes.h"
#include "view.h"

using namespace lessons;

namespace codeling {

namespace {

/// Returns a step with the settings that all steps of this lesson share. `id` is also the marker of its
/// set-up function.
Step newStep(const char *id)
{
    Step step = lessons::makeStep("codeling", id);
    step.traceColumns = TraceColumns::position;
    step.interactions = {Interaction::drag, Interaction::target};
    step.view = spineView;
    step.overlays = targetAndPull;
    return step;
}

/// Returns a step with a soft spine.
Step softStep(const char *id)
{
    Step step = newStep(id);
    step.parameters = {anticipationPart()};
    step.addParameters(spineParameters());
    step.addParameters({restLength()});
    step.addParameters(motorParameters());
    step.measures = {stretchMeasure(), anticipationMeasure()};
    return step;
}

}

Step motorStep()
{
    Step step = newStep("motor");
    step.addParameters(motorParameters());
    step.readTexts(motorChecks());
    step.scene = motor::setUp;
    step.measures = {anticipationMeasure()};
    return step;
}

Step orientationStep()
{
    Step step = newStep("orientation");
    step.addParameters({restLength()});
    step.addParameters(motorParameters());
    step.readTexts(orientationChecks());
    step.scene = orientation::setUp;
    step.measures = {anticipationMeasure()};
    return step;
}

Step anticipationStep()
{
    Step step = newStep("anticipation");
    step.addParameters({anticipationPart(), restLength()});
    step.addParameters(motorParameters());
    step.readTexts(anticipationChecks());
    step.scene = anticipation::setUp;
    step.measures = {anticipationMeasure()};
    return step;
}

Step squashStretchStep()
{
    Step step = softStep("squash_stretch");
    step.readTexts(squashStretchChecks());
    step.scene = squash_stretch::setUp;
    step.view = stretchingView;
    return step;
}

Step volumeStep()
{
    Step step = softStep("volume");
    step.readTexts(volumeChecks());
    step.scene = volume::setUp;
    step.view = bodyView;
    step.measures.insert(step.measures.begin(), {areaMeasure(), widthMeasure()});
    return step;
}

Step tentaclesStep()
{
    Step step = softStep("tentacles");
    std::vector<Parameter> parameters = tentacleParameters();
    parameters.insert(parameters.end(), step.parameters.begin(), step.parameters.end());
    step.parameters = parameters;
    step.readTexts(tentaclesChecks());
    step.scene = tentacles::setUp;
    step.view = bodyView;
    step.measures.insert(step.measures.begin(), areaMeasure());
    return step;
}

}
