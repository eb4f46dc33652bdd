#include "steps.h"

#include "checks.h"
#include "lessons/accuracy/text.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "scenes.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace accuracy {

namespace {

/// Returns a step with the settings that all steps of this lesson share. It shows the exact motion in the
/// scene and measures the error.
Step newStep(const char *id, const Exact &exact)
{
    Step step = lessons::makeStep("accuracy", id);
    step.view = [](const sim::Scene &scene, const sim::Values &) { return creatureViewWithLegs(scene); };
    step.runOverlays = [exact](const sim::Script &script, const sim::State &state, std::int64_t frame) {
        const sim::Scene scene = script.build(script.values);
        return exactOverlays(*exact, creatureView(scene), script, state, frame);
    };
    step.measures = {errorMeasure(exact)};
    step.method = "semi_implicit_euler";
    return step;
}

Parameter creatures()
{
    Parameter parameter = {
        .id = "creatures",
        .name = Text::tr("Creatures"),
        .help = Text::tr("How many creatures there are."),
        .defaultValue = 200.0,
        .min = 1.0,
        .max = 100'000.0,
        .sliderMin = 1.0,
        .sliderMax = 100'000.0,
        .decimals = 0,
        .isInteger = true,
    };
    parameter.scale = Scale::logarithmic;
    return parameter;
}

Exact newExact()
{
    return std::make_shared<ExactRun>();
}

}

Step bigStep()
{
    const Exact exact = newExact();
    Step step = newStep("big_step", exact);
    step.addParameters({stiffness(0.2), damping(1.0)});
    step.readTexts(bigStepChecks(exact));
    step.scene = big_step::setUp;
    step.overlays = turningPoints;
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step energyStep()
{
    const Exact exact = newExact();
    Step step = newStep("energy", exact);
    step.addParameters({stiffness(0.02), damping(1.0)});
    step.readTexts(energyChecks(exact));
    step.scene = energy::setUp;
    step.overlays = turningPoints;
    step.measures.insert(step.measures.begin(), driftMeasure(exact));
    return step;
}

Step halveStep()
{
    const Exact exact = newExact();
    Step step = newStep("halve", exact);
    step.addParameters({stiffness(0.2), damping(0.97), radius()});
    step.readTexts(halveChecks(exact, step.defaultValues()));
    step.scene = halve::setUp;
    step.measures.front().decimals = 5; // the error of Runge–Kutta 4 is 0.00003 px
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step adaptStep()
{
    const Exact exact = newExact();
    Step step = newStep("adapt", exact);
    step.addParameters({stiffness(0.02), damping(1.0), radius()});
    step.method = "dormand_prince";
    step.readTexts(adaptChecks(exact, step.defaultValues()));
    step.scene = adapt::setUp;
    step.overlays = turningRings;
    step.view = smallBodyView;
    step.measures.push_back(stepMeasure());
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step bounceStep()
{
    const Exact exact = newExact();
    Step step = newStep("bounce", exact);
    step.addParameters({lessons::gravity(), lessons::bounce(), damping(1.0)});
    step.addParameters(room());
    step.method = "rk4";
    step.readTexts(bounceChecks(exact, step.defaultValues()));
    step.scene = accuracy::bounce::setUp;
    step.view = ballInRoomView;
    step.runOverlays = [exact](const sim::Script &script, const sim::State &state, std::int64_t frame) {
        return exactOverlays(*exact, ballView(script.values), script, state, frame);
    };
    step.measures.push_back(driftMeasure(exact));
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step budgetStep()
{
    const Exact exact = newExact();
    Step step = newStep("budget", exact);
    step.addParameters({stiffness(0.1), damping(0.97), radius()});
    step.readTexts(budgetChecks(step.defaultValues()));
    step.scene = budget::setUp;
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step crowdStep()
{
    Step step = lessons::makeStep("accuracy", "crowd");
    step.addParameters(
        {creatures(), lessons::gravity(), lessons::bounce(), stiffness(0.2), damping(0.85), radius()});
    step.method = "semi_implicit_euler";
    step.readTexts(crowdChecks());
    step.scene = crowd::setUp;
    step.view = crowdView;
    return step;
}

}
