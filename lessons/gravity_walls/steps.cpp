#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/acting.h"
#include "lessons/api/view/creature_view.h"
#include "lessons/gravity_walls/text.h"
#include "scenes.h"
#include "sim/effects/contacts/walls.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <QCoreApplication>

using namespace lessons;

namespace gravity_walls {

namespace {

View roomView(const sim::Scene &scene, const sim::Values &)
{
    View view = creatureViewWithLegs(scene);
    if (const auto *walls = effectOf<sim::Walls>(scene))
        view.room = walls->room();
    return view;
}

Step newStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("gravity_walls", id, title);
    step.view = roomView;
    return step;
}

}

Step wallsStep()
{
    Step step = newStep("walls", Text::tr("Walls"));
    step.addParameters({bounce(), stiffness(), damping(0.85), radius(), feet(5)});
    step.addParameters(room());
    step.narration = Text::tr(
        "Two walls and a floor. After each move they ask: **is an edge past me?** A place is the middle of "
        "a disc, so half its width counts: 15 px for the body, 5 px for a foot.\n\n"
        "What went too far is put back until its edge touches the wall. Then its velocity across the wall "
        "is turned round: times −1, and times **bounce**, the share that it keeps. At 0 it stays at the "
        "wall.\n\n"
        "A body in your hand meets no wall, and there is no ceiling.\n\n"
        "(The tutorial behind this lesson calls the wall at 20 px “right” and the one at 520 px “left”. "
        "Here left is left.)");
    step.explanation = wallsExplanation();
    step.tries = wallsTries();
    step.codeTasks = wallsCodeTasks();
    step.scene = walls::setUp;
    return step;
}

Step gravityStep()
{
    Step step = newStep("gravity", Text::tr("Gravity"));
    step.addParameters({lessons::gravity(), bounce(), stiffness(), damping(0.85), radius(), feet(4)});
    step.addParameters(room());
    step.narration = Text::tr(
        "**Gravity** is one more pull that adds up: straight down, and the same for everything. y points "
        "down, so it adds to the y of the velocity.\n\n"
        "It comes **before damping**, beside the springs. So what hangs still has pulls that cancel: a foot "
        "hangs where its spring pulls up as much as gravity pulls down, **whatever the damping**. Were "
        "gravity added after damping, more damping would mean hanging lower.\n\n"
        "On the floor nothing holds the feet: they slide apart, and the body comes down between them. Its "
        "velocity there is not 0: in each frame gravity pulls it into the floor and the floor turns "
        "it round.");
    step.explanation = gravityExplanation();
    step.tries = gravityTries();
    step.codeTasks = gravityCodeTasks();
    step.scene = gravity::setUp;
    return step;
}

}
