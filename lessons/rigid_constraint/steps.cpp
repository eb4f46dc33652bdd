#include "steps.h"

#include "checks.h"
#include "lessons/api/parameters.h"
#include "lessons/rigid_constraint/text.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace rigid_constraint {

namespace {

Parameter length(double defaultValue)
{
    return {
        .id = "length",
        .name = Text::tr("Length"),
        .unit = Text::tr("px"),
        .help = Text::tr("How far apart a stick keeps its two ends."),
        .defaultValue = defaultValue,
        .min = 0.0,
        .max = 1e6,
        .sliderMin = 0.0,
        .sliderMax = 200.0,
        .decimals = 0,
    };
}

Parameter share()
{
    return {
        .id = "share",
        .name = Text::tr("Share"),
        .help = Text::tr("The part of the error that p0 takes; p1 takes the rest."),
        .defaultValue = 1.0,
        .min = 0.0,
        .max = 1.0,
        .sliderMin = 0.0,
        .sliderMax = 1.0,
    };
}

Parameter triangles()
{
    return {
        .id = "triangles",
        .name = Text::tr("Triangles"),
        .help = Text::tr("How many triangles the figure has."),
        .defaultValue = 6.0,
        .min = 1.0,
        .max = 900.0,
        .sliderMin = 1.0,
        .sliderMax = 20.0,
        .decimals = 0,
        .isInteger = true,
    };
}

Parameter iterations(double defaultValue)
{
    return {
        .id = "iterations",
        .name = Text::tr("Iterations"),
        .unit = Text::tr("passes"),
        .help = Text::tr("How often each frame goes through the list of sticks."),
        .defaultValue = defaultValue,
        .min = 1.0,
        .max = 1000.0,
        .sliderMin = 1.0,
        .sliderMax = 50.0,
        .decimals = 0,
        .isInteger = true,
        .role = ParameterRole::iterations,
    };
}

Parameter friction()
{
    return {
        .id = "friction",
        .name = Text::tr("Friction"),
        .help = Text::tr("How much a wall’s push holds back what slides along it. 0: like ice."),
        .defaultValue = 0.5,
        .min = 0.0,
        .max = 10.0,
        .sliderMin = 0.0,
        .sliderMax = 2.0,
    };
}

Parameter jointLimits()
{
    return {
        .id = "joint_limits",
        .name = Text::tr("Joints"),
        .help = Text::tr("Whether arms and legs bend only as far as joints do, or all the way round."),
        .defaultValue = 1.0,
        .min = 0.0,
        .max = 1.0,
        .sliderMin = 0.0,
        .sliderMax = 1.0,
        .decimals = 0,
        .choices = {"free", "limited"},
        .choiceTitles = {Text::tr("free"), Text::tr("limited")},
    };
}

/// Returns a step with the settings that all steps of this lesson share. `id` is also the marker of its
/// set-up function.
Step newStep(const char *id)
{
    Step step = lessons::makeStep("rigid_constraint", id);
    step.traceColumns = TraceColumns::position;
    step.points = PointSource::file;
    return step;
}

/// Returns a step in which point 0 follows the pointer.
Step pointerStep(const char *id)
{
    Step step = newStep(id);
    step.interactions = {Interaction::drag, Interaction::pointer};
    step.view = pointerView;
    step.measures = {errorMeasure()};
    return step;
}

/// Returns a step in a room. Its method uses regularised directions, so coincident points separate in
/// different directions and not along one line.
Step roomStep(const char *id)
{
    Step step = newStep(id);
    step.measures = {stretchMeasure()};
    step.method = "semi_implicit_euler";
    return step;
}

}

Step pairStep()
{
    Step step = pointerStep("pair");
    step.addParameters({length(100)});
    step.readTexts(pairChecks());
    step.scene = pair::setUp;
    return step;
}

Step sharedErrorStep()
{
    Step step = pointerStep("shared_error");
    step.addParameters({share(), length(100)});
    step.readTexts(sharedErrorChecks());
    step.scene = shared_error::setUp;
    return step;
}

Step triangleStep()
{
    Step step = pointerStep("triangle");
    step.addParameters({length(100)});
    step.readTexts(triangleChecks());
    step.scene = triangle::setUp;
    return step;
}

Step listStep()
{
    Step step = pointerStep("list");
    step.addParameters({triangles(), length(50)});
    step.readTexts(listChecks());
    step.scene = list::setUp;
    return step;
}

Step verletStep()
{
    Step step = roomStep("verlet");
    step.addParameters({iterations(1), lessons::gravity(), damping(0.99), friction()});
    step.addParameters(room());
    step.readTexts(verletChecks());
    step.scene = verlet::setUp;
    step.view = boxView;
    return step;
}

Step ragdollStep()
{
    Step step = roomStep("ragdoll");
    step.addParameters({iterations(10), jointLimits(), lessons::gravity(), damping(0.99), friction()});
    step.addParameters(room());
    step.readTexts(ragdollChecks());
    step.scene = ragdoll::setUp;
    step.view = ragdollView;
    return step;
}

}
