#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
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
        .name = Text::tr("Share of p0"),
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
Step newStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("rigid_constraint", id, title);
    step.traceColumns = TraceColumns::position;
    step.points = PointSource::file;
    return step;
}

/// Returns a step in which point 0 follows the pointer.
Step pointerStep(const char *id, const QString &title)
{
    Step step = newStep(id, title);
    step.interactions = {Interaction::drag, Interaction::pointer};
    step.view = pointerView;
    step.measures = {errorMeasure()};
    return step;
}

/// Returns a step in a room. Its method uses regularised directions, so coincident points separate in
/// different directions and not along one line.
Step roomStep(const char *id, const QString &title)
{
    Step step = newStep(id, title);
    step.measures = {stretchMeasure()};
    step.method = "semi_implicit_euler";
    return step;
}

}

Step pairStep()
{
    Step step = pointerStep("pair", Text::tr("A pair"));
    step.narration = Text::tr(
        "A **stick** is a rule: these two points are 100 px apart, whatever happens. Such a rule is called "
        "a **constraint**. The pointer carries p0, and the rule does the rest.\n\n"
        "Each frame the code measures the distance. What it has too much is the **error**; below 0 it has "
        "too little. Both points go along the stick, and each takes **half of the error**. Then the "
        "distance is right, in one go: there is no spring here, and no velocity.\n\n"
        "Both points start in one place, where a stick has no direction. `atan2(0, 0)` is 0, so they part "
        "straight up and down.\n\n"
        "This angle is counted from the y axis: that is why dx comes first in `atan2`.");
    step.addParameters({length(100)});
    step.explanation = pairExplanation();
    step.tries = pairTries();
    step.codeTasks = pairCodeTasks();
    step.scene = pair::setUp;
    return step;
}

Step sharedErrorStep()
{
    Step step = pointerStep("shared_error", Text::tr("Who takes the error"));
    step.narration = Text::tr(
        "Half each is not always what you want. **share** is the part of the error that p0 takes, from 0 to "
        "1. p1 takes the rest.\n\n"
        "At 1, p1 is a nail. The pointer takes p0 away, and the stick brings it back to 100 px from the "
        "nail, on the side where the pointer is.\n\n"
        "At 0, p0 stays at the pointer and p1 is pulled along.\n\n"
        "In between, both move. The pointer puts p0 back each frame, so the stick is wrong again. While the "
        "pointer stands still, **each frame leaves share of the error**: at 0.5 half of it, then a quarter, "
        "and p0 comes to the pointer after all.");
    step.addParameters({share(), length(100)});
    step.explanation = sharedErrorExplanation();
    step.tries = sharedErrorTries();
    step.codeTasks = sharedErrorCodeTasks();
    step.scene = shared_error::setUp;
    return step;
}

Step triangleStep()
{
    Step step = pointerStep("triangle", Text::tr("A triangle"));
    step.narration = Text::tr(
        "Three points, three sticks: the same function three times, one after the other. Each stick makes "
        "its own distance right, and **the ones before it a little wrong again**.\n\n"
        "Move the pointer slowly, and you hardly see it. Move it fast, and the triangle is out of shape: "
        "one round of corrections is not enough. The next frame corrects what is left, so it comes back "
        "to its shape in a few frames.\n\n"
        "The three start in one place and part on one line. They stay on that line until the pointer "
        "leaves it: on a line no stick knows a way to the side.\n\n"
        "Three sticks of 100 px can all be right at once. Sticks of 100, 100 and 300 px never can: some "
        "error would stay for ever.");
    step.addParameters({length(100)});
    step.explanation = triangleExplanation();
    step.tries = triangleTries();
    step.scene = triangle::setUp;
    return step;
}

Step listStep()
{
    Step step = pointerStep("list", Text::tr("A list of sticks"));
    step.narration = Text::tr(
        "Copied lines will not do for a big figure. Here **a loop** fills a list of sticks: each point is "
        "tied to the one before it and to the one before that, which gives a row of triangles. A second "
        "loop goes through the list each frame and enforces one stick after the other.\n\n"
        "**The order matters.** A pull at p0 runs down the list in one frame, as each stick sees what the "
        "one before it moved. A correction that has to go the other way gets one stick further each "
        "frame.\n\n"
        "A stick’s colour shows its error. After a fast move you can watch the error spread, and shrink "
        "frame by frame.");
    step.addParameters({triangles(), length(50)});
    step.explanation = listExplanation();
    step.tries = listTries();
    step.codeTasks = listCodeTasks();
    step.scene = list::setUp;
    return step;
}

Step verletStep()
{
    Step step = roomStep("verlet", Text::tr("Points that move"));
    step.narration = Text::tr(
        "Now the points move by themselves, and fall. But a stick puts a point elsewhere without asking "
        "its velocity. The remedy: **do not keep a velocity. It is the way that the point came**, its place "
        "now minus its place one frame before:\n\n"
        "`x + (x − before) + g`\n\n"
        "is the next place. This is **Verlet integration**. Watch the phases: move, sticks, room, and then "
        "the new velocity is read off. Whatever moved the point is in it.\n\n"
        "Walls are constraints, too: no point may be past one. **Friction** holds back what slides along "
        "them.\n\n"
        "**iterations** says how often a frame goes through the list of sticks. At 1 this box gives way "
        "like rubber; more make it stiff.");
    step.addParameters({iterations(1), lessons::gravity(), damping(0.99), friction()});
    step.addParameters(room());
    step.explanation = verletExplanation();
    step.tries = verletTries();
    step.codeTasks = verletCodeTasks();
    step.scene = verlet::setUp;
    step.view = boxView;
    return step;
}

Step ragdollStep()
{
    Step step = roomStep("ragdoll", Text::tr("A ragdoll"));
    step.narration = Text::tr(
        "A whole figure: 12 points and 14 sticks. Three sticks make the torso a triangle, which cannot be "
        "bent. Three more hold the head on it: two from the shoulders, and one from the hip as a **brace**. "
        "Arms and legs are two sticks each.\n\n"
        "Sticks alone let a knee turn all the way round. **Joint limits** are constraints that act only "
        "when they are broken: when the angle at a joint is past its limit, both limbs are turned back, "
        "half of it each.\n\n"
        "Drag it, throw it, drop it. A stick’s colour shows what error is left after all iterations, and "
        "the figure beside the scene shows the worst one. Each pass takes a part of the error, so **twice "
        "the passes leave less**, and cost twice as much.");
    step.addParameters({iterations(10), jointLimits(), lessons::gravity(), damping(0.99), friction()});
    step.addParameters(room());
    step.explanation = ragdollExplanation();
    step.tries = ragdollTries();
    step.scene = ragdoll::setUp;
    step.view = ragdollView;
    return step;
}

}
