#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "lessons/multi_foot/text.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <QCoreApplication>

using namespace lessons;

namespace multi_foot {

namespace {

View viewWithLegs(const sim::Scene &scene, const sim::Values &)
{
    return creatureViewWithLegs(scene);
}

Step newStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("multi_foot", id, title);
    step.parameters = {stiffness(), damping(0.85), radius()};
    step.view = viewWithLegs;
    return step;
}

}

Step twoFeetStep()
{
    Step step = newStep("two_feet", Text::tr("Two feet"));
    step.narration = Text::tr(
        "Each foot keeps its distance from the body, as before. The body keeps its distance from "
        "**both** feet.\n\n"
        "Two pulls on one body need no new formula: **they add up**. The first pull goes onto the "
        "velocity, then the second. Damping comes once, after all pulls, and then the body moves.\n\n"
        "Damping is 0.85 from here on. The feet still move before the body, and each spring makes a "
        "little momentum from nothing. At 0.9 that is more than damping takes, and the creature leaves "
        "the picture.");
    step.explanation = twoFeetExplanation();
    step.tries = twoFeetTries();
    step.codeTasks = twoFeetCodeTasks();
    step.scene = two_feet::setUp;
    return step;
}

Step anyNumberStep()
{
    Step step = newStep("any_number", Text::tr("Any number of feet"));
    step.parameters.push_back(feet(5));
    step.narration = Text::tr(
        "Two more springs for each new foot could be written out, one line each. Instead **one loop** "
        "adds them: the loop does not know how many feet there are.\n\n"
        "The number is a parameter now. The first five feet have places of their own; more than five "
        "start on a circle round the body.\n\n"
        "Feet do not feel each other. They feel the body, and **the body feels every foot**, so a tug "
        "at one foot reaches all the others through it.");
    step.explanation = anyNumberExplanation();
    step.tries = anyNumberTries();
    step.codeTasks = anyNumberCodeTasks();
    step.scene = any_number::setUp;
    return step;
}

Step grownFeetStep()
{
    Step step = newStep("grown_feet", Text::tr("Feet that grow"));
    step.parameters.push_back(feet(5));
    step.narration =
        Text::tr("Now the code places the feet, too: each **at random**, up to 50 px from the body in "
                 "x and in y. One number, the **seed**, decides all of them, so a run can be repeated.\n\n"
                 "**Stay below a dozen feet.** Each foot adds work to each frame. And the body feels "
                 "every foot: the more there are, the stiffer it is held. At some number a step of a "
                 "whole frame carries the body past its place by more than it was away, and every "
                 "swing is wider than the last. From about 10 on they tremble, 16 mostly fly off, 60 "
                 "explode.\n\n"
                 "The springs are not to blame: with two steps of half a frame each, 60 feet hold.");
    step.explanation = grownFeetExplanation();
    step.tries = grownFeetTries();
    step.codeTasks = grownFeetCodeTasks();
    step.scene = grown_feet::setUp;
    return step;
}

}
