#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
#include "lessons/api/parameters.h"
#include "lessons/single_spring/text.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace single_spring {

namespace {

/// Returns a step with the settings that all steps of this lesson share. `id` is also the marker of its
/// set-up function.
Step newStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("single_spring", id, title);
    step.parameters = {stiffness(), damping()};
    step.view = discsAndSprings;
    return step;
}

}

Step dragStep()
{
    Step step = newStep("drag", Text::tr("Drag and throw"));
    step.narration = Text::tr(
        "This dot is a **foot**. Its place is two numbers: **x** pixels (px) to the right, **y** pixels "
        "down. Its **velocity** is two numbers as well: how far it goes in x and in y from one picture, "
        "a **frame**, to the next.\n\n"
        "While you hold the foot, its velocity is how far your hand moved in the last frame. "
        "When you let go it keeps that. So **a moving hand throws it**.\n\n"
        "**Damping** is the share of its velocity that it keeps each frame. At 0.9 a throw of "
        "10 px per frame glides 90 px and stops.\n\n"
        "The arrow is the pull that a spring to the cross would have. It does not act yet: that is "
        "the next step.");
    step.addParameters(centre());
    for (Parameter &parameter : step.parameters) {
        if (parameter.id != QStringLiteral("damp")) // nothing pulls yet: shown from the next step on
            parameter.effects = {QStringLiteral("point_spring")};
    }
    step.explanation = dragExplanation();
    step.tries = dragTries();
    step.codeTasks = dragCodeTasks();
    step.scene = drag::setUp;
    step.overlays = inactivePull;
    return step;
}

Step fixedCentreStep()
{
    Step step = newStep("fixed_centre", Text::tr("A fixed centre"));
    step.narration =
        Text::tr("A **spring**, the zigzag, pulls the foot to the cross. The pull is the distance times the "
                 "stiffness **k**: twice as far, **twice the pull**. That is Hooke’s law.\n\n"
                 "x and y are worked out apart. The distance in x changes the velocity in x, the "
                 "distance in y the velocity in y. Together they point at the cross.\n\n"
                 "Each frame has three phases: the spring adds its pull to the velocity, damping takes "
                 "its share, and the foot moves.\n\n"
                 "The foot is fastest near the cross, where the pull is weakest, so it **overshoots** "
                 "and swings back. Damping makes each swing smaller, until the foot stands on the "
                 "cross, where the pull is 0.");
    step.addParameters(centre());
    step.explanation = fixedCentreExplanation();
    step.tries = fixedCentreTries();
    step.codeTasks = fixedCentreCodeTasks();
    step.scene = fixed_centre::setUp;
    step.overlays = centreCross;
    return step;
}

Step movingBodyStep()
{
    Step step = newStep("moving_body", Text::tr("A moving body"));
    step.narration = Text::tr(
        "Now the spring ends at the **body**, and you can carry the body about. The spring reads the "
        "body’s place anew in each frame, so **the foot follows wherever you go**. Its formula is the "
        "same as before: only the centre is now a place that moves.\n\n"
        "The foot comes late. The pull changes its velocity, and only the velocity changes its "
        "place.\n\n"
        "This body is a handle: it feels no pull and keeps no velocity, and stays where you leave it.");
    step.explanation = movingBodyExplanation();
    step.tries = movingBodyTries();
    step.codeTasks = movingBodyCodeTasks();
    step.scene = moving_body::setUp;
    return step;
}

Step offsetStep()
{
    Step step = newStep("offset", Text::tr("An offset"));
    step.narration = Text::tr(
        "The foot came to rest on top of the body, and one hid the other. So give the spring another "
        "**target**: the cross, 50 px to the right of the body. The **offset** is added to the body’s x; "
        "its y stays.\n\n"
        "Nothing else changes: the pull is still k times the distance, now to the target.\n\n"
        "But **an offset chooses the side for the foot**. From wherever you let it go, it ends on the "
        "right. To keep the distance and leave the side free you need more than an offset: a "
        "direction.");
    step.addParameters({lessons::offset()});
    step.explanation = offsetExplanation();
    step.tries = offsetTries();
    step.codeTasks = offsetCodeTasks();
    step.scene = offset::setUp;
    step.overlays = offsetCross;
    return step;
}

Step radialStep()
{
    Step step = newStep("radial", Text::tr("Any direction"));
    step.narration =
        Text::tr("The target is now 50 px from the body **in the direction in which the foot is**: any "
                 "place on the ring will do.\n\n"
                 "dx and dy, the x and y of `from` in the code, lead from the body to the foot. "
                 "`atan2(dy, dx)` makes them one **angle**, counted from the x axis. y points down, so "
                 "it grows clockwise.\n\n"
                 "The angle is in **radians**: 1 rad = 57.2958°, and half a turn is 3.1416 rad. (The "
                 "tutorial behind this lesson says about 59°; its code is right all the same, as it "
                 "never needs degrees.)\n\n"
                 "`cos` and `sin` lead back: the x and y of a way of 1 px at that angle. Times "
                 "**radius**, plus the body’s place: that is the target.");
    step.addParameters({lessons::radius()});
    step.explanation = radialExplanation();
    step.tries = radialTries();
    step.codeTasks = radialCodeTasks();
    step.scene = radial::setUp;
    step.overlays = ringAndAngle;
    return step;
}

}
