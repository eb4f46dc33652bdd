#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
#include "lessons/api/parameters.h"
#include "lessons/two_body/text.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <QCoreApplication>

using namespace lessons;

namespace two_body {

namespace {

Step newStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("two_body", id, title);
    step.parameters = {stiffness(), damping(), radius()};
    return step;
}

}

Step mutualStep()
{
    Step step = newStep("mutual", Text::tr("Each pulls the other"));
    step.narration =
        Text::tr("Now **both are pulled**: the foot to a place 50 px from the body, and the body to a "
                 "place 50 px from the foot. It is one rule, used twice.\n\n"
                 "The foot moves first, and the body sees it **where it already is**. So the two pulls "
                 "are not quite opposite, and the velocities add up to more than nothing. That sum is "
                 "the **momentum**, and here it comes from nowhere: the pair drifts.\n\n"
                 "With k = 0.3 it flies for ever. Set damping to 0.85 as well, and it calms down: "
                 "damping then takes more than the order of moves gives.\n\n"
                 "The method Semi-implicit Euler moves both **at once**. Their pulls are opposite, and "
                 "the momentum stays 0.");
    step.explanation = mutualExplanation();
    step.tries = mutualTries();
    step.codeTasks = mutualCodeTasks();
    step.scene = mutual::setUp;
    step.view = [](const sim::Scene &scene, const sim::Values &) { return mutual::look(scene); };
    return step;
}

Step legLineStep()
{
    Step step = newStep("leg_line", Text::tr("A leg"));
    step.narration = Text::tr(
        "A body, a foot, and now a **leg**: a line from one to the other. In the code it is one line, "
        "too.\n\n"
        "It is drawn after each frame, from the two places as they are then, so it always fits. It adds "
        "no pull and costs no phase: **what is drawn cannot change what is computed**.\n\n"
        "But it shows how long the spring is. Where it is longer than **radius**, the spring pulls its two "
        "ends "
        "together; where it is shorter, the spring pushes them apart; and at 50 px it does nothing.");
    step.explanation = legLineExplanation();
    step.tries = legLineTries();
    step.codeTasks = legLineCodeTasks();
    step.scene = leg_line::setUp;
    step.view = [](const sim::Scene &scene, const sim::Values &) { return leg_line::look(scene); };
    return step;
}

}
