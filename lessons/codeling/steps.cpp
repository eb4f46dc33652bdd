#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
#include "lessons/codeling/text.h"
#include "parameters.h"
#include "scenes.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace codeling {

namespace {

/// Returns a step with the settings that all steps of this lesson share. `id` is also the marker of its
/// set-up function.
Step newStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("codeling", id, title);
    step.traceColumns = TraceColumns::position;
    step.interactions = {Interaction::drag, Interaction::target};
    step.view = spineView;
    step.overlays = targetAndPull;
    return step;
}

/// Returns a step with a soft spine.
Step softStep(const char *id, const QString &title)
{
    Step step = newStep(id, title);
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
    Step step = newStep("motor", Text::tr("A motor"));
    step.narration = Text::tr(
        "Click anywhere: this little creature swims there. Its motor is a **spring** from its head, the "
        "**lead**, to the target. The pull is k times the way to go, so it starts fast, slows down by "
        "itself, and swims a little too far before it turns back.\n\n"
        "**keep** is the share of its velocity that it keeps each frame. With 1 it would swing about the "
        "target for ever. With 0.7 it is there after a dozen frames.\n\n"
        "A frame is a quarter of this creature’s own unit of time: **dt** is 0.25. A pull changes a place "
        "by dt × dt, so k = 0.9 does as much as k = 0.056 in the first lessons.");
    step.addParameters(motorParameters());
    step.explanation = motorExplanation();
    step.tries = motorTries();
    step.codeTasks = motorCodeTasks();
    step.scene = motor::setUp;
    step.measures = {anticipationMeasure()};
    return step;
}

Step orientationStep()
{
    Step step = newStep("orientation", Text::tr("Which way it looks"));
    step.narration = Text::tr(
        "A dot has no front. So give it a second point, the **tail**, tied to the lead by a rigid stick of "
        "40 px.\n\n"
        "This stick is **one-sided**: the lead takes nothing of the error, the tail takes it all. The motor "
        "does not even know that there is a tail. And the tail has no velocity of its own: it is pulled "
        "along behind, wherever the lead goes.\n\n"
        "That is enough for a direction: from tail to lead is the way that it looks. When it is sent to the "
        "side, it turns there in a smooth curve. When it is sent straight back, it pushes its tail ahead of "
        "it for a while: the stick knows a length, not a front.\n\n"
        "In each frame the lead moves first. The tail follows in the same frame.");
    step.addParameters({restLength()});
    step.addParameters(motorParameters());
    step.explanation = orientationExplanation();
    step.tries = orientationTries();
    step.codeTasks = orientationCodeTasks();
    step.scene = orientation::setUp;
    step.measures = {anticipationMeasure()};
    return step;
}

Step anticipationStep()
{
    Step step = newStep("anticipation", Text::tr("Anticipation"));
    step.narration = Text::tr(
        "Before you jump, you crouch. Animators call that **anticipation**: a small move the other way "
        "tells the eye that a big one is coming.\n\n"
        "When you click, the lead is shifted **away from the target** by a part of "
        "the way, 0.2 of it.\n\n"
        "Its place before that frame stays what it was. The velocity is the way that it came, so the shift "
        "is also a push: it goes on backing up, slower and slower, until the motor has turned it round. "
        "A longer way gives a bigger shift, with no number to be set for it.\n\n"
        "Two clicks in one frame shift it twice.");
    step.addParameters({anticipationPart(), restLength()});
    step.addParameters(motorParameters());
    step.explanation = anticipationExplanation();
    step.tries = anticipationTries();
    step.codeTasks = anticipationCodeTasks();
    step.scene = anticipation::setUp;
    step.measures = {anticipationMeasure()};
    return step;
}

Step squashStretchStep()
{
    Step step = softStep("squash_stretch", Text::tr("Squash and stretch"));
    step.narration = Text::tr(
        "Now the tail gets a velocity of its own, and the stick gives way: it is **soft**. The tail drags "
        "behind and swings past, and the body is squashed and stretched along its **spine**, the line from "
        "tail to "
        "lead.\n\n"
        "Each frame takes only 0.1 of the error. But a soft stick alone would let the tail pass through the "
        "lead. So there are **three cases**: shorter than 20 px or longer than 60 px, it takes 0.8 of what "
        "is past that limit; in between, 0.1 of the way to 40 px.\n\n"
        "The tail’s velocity is split in two, **along** the spine and **across** it. Along, it keeps 0.7 "
        "each frame, across only 0.5: it bobs more than it swings round.");
    step.explanation = squashStretchExplanation();
    step.tries = squashStretchTries();
    step.scene = squash_stretch::setUp;
    step.view = stretchingView;
    return step;
}

Step volumeStep()
{
    Step step = softStep("volume", Text::tr("Volume"));
    step.narration = Text::tr(
        "A body that gets shorter must get wider, or it seems to lose weight. Two more points make the "
        "**sides**, with five more constraints.\n\n"
        "Four are soft and one-sided: from lead and tail to each side. They keep the sides in the middle.\n\n"
        "The fifth is rigid and goes across, from side to side. **Its length follows from the area**: half "
        "of spine times width is the area of this shape, so the width that it needs is 2 × area / spine. "
        "Half as long makes twice as wide.\n\n"
        "In a sharp turn the sides come late and the shape buckles; "
        "calmer moves look better.");
    step.explanation = volumeExplanation();
    step.tries = volumeTries();
    step.codeTasks = volumeCodeTasks();
    step.scene = volume::setUp;
    step.view = bodyView;
    step.measures.insert(step.measures.begin(), {areaMeasure(), widthMeasure()});
    return step;
}

Step tentaclesStep()
{
    Step step = softStep("tentacles", Text::tr("Tentacles"));
    step.narration = Text::tr(
        "The sides carry **tentacles**: chains of points with sticks between them. Each point goes on as it "
        "came (Verlet), and **water** leaves it a share of its speed. Then the sticks pull it in.\n\n"
        "These sticks are one-sided, too. From the side outwards, each link puts its outer end right and "
        "leaves the inner one alone. So **one pass is enough**: no later link disturbs an earlier one, and "
        "every link has exactly its 7 px.\n\n"
        "The price: a tentacle feels the body, but the body does not feel the tentacle. For something so "
        "light that is a fair lie.\n\n"
        "Nothing here was drawn frame by frame: springs and constraints do all of it.");
    std::vector<Parameter> parameters = tentacleParameters();
    parameters.insert(parameters.end(), step.parameters.begin(), step.parameters.end());
    step.parameters = parameters;
    step.explanation = tentaclesExplanation();
    step.tries = tentaclesTries();
    step.scene = tentacles::setUp;
    step.view = bodyView;
    step.measures.insert(step.measures.begin(), areaMeasure());
    return step;
}

}
