#include "steps.h"

#include "cases.h"
#include "checks.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "lessons/hard_cases/text.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace hard_cases {

namespace {

/// Returns a step whose run is drawn on `stage` beside that of `companion`.
Step newStep(const char *id, const QRectF &stage, const Companion &companion)
{
    Step step = lessons::makeStep("hard_cases", id);
    step.companion = companion;
    step.view = [stage](const sim::Scene &scene, const sim::Values &) {
        View view = creatureViewWithLegs(scene);
        view.stage = stage;
        return view;
    };
    return step;
}

Parameter stiffnessUpTo(double defaultValue, double sliderMax)
{
    Parameter parameter = stiffness(defaultValue);
    parameter.sliderMax = sliderMax;
    if (sliderMax >= 1000.0)
        parameter.decimals = 1; // the field has room for six characters
    return parameter;
}

Parameter feetUpTo(int defaultValue, int sliderMax)
{
    Parameter parameter = lessons::feet(defaultValue);
    parameter.sliderMax = sliderMax;
    return parameter;
}

Parameter longest()
{
    Parameter parameter = radius(200.0);
    parameter.id = "longest";
    parameter.name = Text::tr("Longest");
    parameter.help = Text::tr("The length of the third stick. The other two are 20 px long.");
    parameter.sliderMax = 250.0;
    return parameter;
}

}

Step limitStep()
{
    Step step = newStep(
        "limit", QRectF(10, 130, 520, 110),
        {.method = "implicit_midpoint", .caption = Text::tr("Implicit midpoint"), .offset = {0, 150}});
    step.addParameters({stiffnessUpTo(4.01, 6.0), damping(1.0)});
    step.method = "semi_implicit_euler";
    step.readTexts(limitChecks());
    step.scene = limit::setUp;
    step.overlays = turningPoints;
    return step;
}

Step runawayStep()
{
    Step step = newStep(
        "runaway", QRectF(225, 150, 140, 140),
        {.method = "semi_implicit_euler", .caption = Text::tr("Semi-implicit Euler"), .offset = {180, 0}});
    step.addParameters({stiffnessUpTo(0.3, 1.0), damping(0.9), radius()});
    step.readTexts(runawayChecks());
    step.scene = runaway::setUp;
    step.overlays = centreOverlays;
    return step;
}

Step manyFeetStep()
{
    Step step =
        newStep("many_feet", QRectF(195, 115, 150, 160),
                {.method = "backward_euler", .caption = Text::tr("Backward Euler"), .offset = {190, 0}});
    step.addParameters({feetUpTo(60, 100), stiffnessUpTo(0.2, 1.0), damping(0.85), radius()});
    step.method = "semi_implicit_euler";
    step.readTexts(manyFeetChecks());
    step.scene = many_feet::setUp;
    return step;
}

Step onePlaceStep()
{
    Step step = newStep(
        "one_place", QRectF(195, 115, 150, 160),
        {.method = "semi_implicit_euler", .caption = Text::tr("Semi-implicit Euler"), .offset = {190, 0}});
    step.addParameters({feetUpTo(5, 24), stiffnessUpTo(0.1, 1.0), damping(0.85), radius()});
    step.readTexts(onePlaceChecks());
    step.scene = one_place::setUp;
    return step;
}

Step stiffStep()
{
    Step step =
        newStep("stiff", QRectF(190, 120, 155, 170),
                {.method = "backward_euler", .caption = Text::tr("Backward Euler"), .offset = {195, 0}});
    step.addParameters({stiffnessUpTo(1000.0, 2000.0), damping(0.9), radius()});
    step.method = "semi_implicit_euler";
    step.readTexts(stiffChecks());
    step.scene = stiff::setUp;
    return step;
}

Step contradictionStep()
{
    Step step = newStep(
        "contradiction", QRectF(180, 95, 180, 200),
        {.method = "semi_implicit_euler", .caption = Text::tr("The same, as sticks"), .offset = {230, 0}});
    step.companion->values = {{"made_of", 1.0}};
    Parameter madeOf =
        choice("made_of", Text::tr("Made of"),
               Text::tr("Whether springs hold the three points, or rigid sticks."), {"springs", "sticks"});
    madeOf.choiceTitles = {Text::tr("springs"), Text::tr("sticks")};
    step.addParameters({madeOf, longest(), stiffnessUpTo(1.5, 3.0), damping(0.9)});
    step.view = triangleView;
    step.method = "semi_implicit_euler";
    step.readTexts(contradictionChecks());
    step.scene = contradiction::setUp;
    return step;
}

Step longRunStep()
{
    Step step =
        newStep("long_run", QRectF(140, 150, 260, 80),
                {.method = "velocity_verlet", .caption = Text::tr("Velocity Verlet"), .offset = {0, 100}});
    step.addParameters({stiffnessUpTo(0.5, 2.0), damping(1.0)});
    step.method = "rk4";
    step.readTexts(longRunChecks());
    step.scene = long_run::setUp;
    step.overlays = turningPoints;
    return step;
}

Step tortureStep()
{
    Step step = lessons::makeStep("hard_cases", "torture");
    step.addParameters({caseParameter(), caseStiffness()});
    step.view = caseView;
    step.prepareScript = prepareCase;
    step.note = caseNote();
    step.readTexts(tortureChecks());
    step.scene = torture::setUp;
    step.interactions = {Interaction::drag, Interaction::pointer, Interaction::target};
    return step;
}

}
