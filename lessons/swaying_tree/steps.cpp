#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/tree_view.h"
#include "lessons/swaying_tree/text.h"
#include "parameters.h"
#include "scenes.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace swaying_tree {

namespace {

/// Returns a step with the settings that all steps of this lesson share. `grow` makes the tree for the view.
/// `id` is also the marker of the set-up function.
Step treeStep(const char *id, const QString &title, sim::Tree (*grow)(const sim::Values &))
{
    Step step = lessons::makeStep("swaying_tree", id, title);
    step.view = [grow](const sim::Scene &, const sim::Values &values) { return treeView(grow(values)); };
    step.interactions = {Interaction::drag, Interaction::pointer};
    step.traceColumns = TraceColumns::positionAndAngle;
    return step;
}

/// Returns a step whose tree bends. The parameters `first` precede those of the tree.
Step bentStep(const char *id, const QString &title, const std::vector<Parameter> &first)
{
    Step step = treeStep(id, title, randomness::grow);
    step.addParameters(first);
    step.addParameters({jitter(), spread(), slope(), minScale(), baseLength()});
    step.measures = {bendMeasure()};
    step.overlays = windByBothFormulas;
    step.note = groundNote;
    step.presets = galleryFor(step);
    return step;
}

}

Step trunkStep()
{
    Step step = treeStep("trunk", Text::tr("The trunk"), trunk::grow);
    step.addParameters({baseLength(), formula()});
    step.narration = Text::tr(
        "A branch is three things: where it begins, its **angle**, and its length. Where it ends follows: "
        "`cos` and `sin` of the angle, times the length, lead from its origin to its end.\n\n"
        "The trunk begins in the middle of the ground, 275 px to the right and 400 px down. Its angle "
        "is −90°: y points down, so angles grow clockwise, and minus a quarter turn is straight up. It is "
        "100 px long.\n\n"
        "`cos` and `sin` take radians, so the angle is divided by the degrees to a radian: 57.2958. The "
        "tutorial behind this lesson divides by 57.3. That leans the trunk by 0.0066° to the right, "
        "and its end is 0.0116 px off. The list **Formula** offers both.");
    step.explanation = trunkExplanation();
    step.tries = trunkTries();
    step.scene = trunk::setUp;
    step.overlays = trunkEnd;
    return step;
}

Step branchesStep()
{
    Step step = treeStep("branches", Text::tr("Branches"), branches::grow);
    step.addParameters({spread(), slope(), minScale(), baseLength(), formula()});
    step.narration = Text::tr(
        "Where a branch ends, two smaller ones begin. One leans 30° to the left of it, one to the "
        "right: that is the **spread**. Each is 0.8 times as large: the **slope**. And each of them "
        "does the same.\n\n"
        "Such a rule that uses itself needs an end. A branch grows only while it is **larger than 0.2** "
        "of the trunk. That makes 8 levels: 1 + 2 + 4 + … + 128 = **255 branches** from one rule.\n\n"
        "With a slope of 1 nothing would get smaller and the tree would never end. So the levels "
        "are counted before it grows, and a tree of more than 131071 branches is refused.\n\n"
        "Branches are numbered level by level, from left to right: 0 is the trunk.");
    step.explanation = branchesExplanation();
    step.tries = branchesTries();
    step.codeTasks = branchesCodeTasks();
    step.scene = branches::setUp;
    step.measures = {countMeasure()};
    return step;
}

Step randomnessStep()
{
    Step step = treeStep("randomness", Text::tr("A little chance"), randomness::grow);
    step.addParameters({jitter(), spread(), slope(), minScale(), baseLength(), formula()});
    step.narration = Text::tr(
        "Real trees are not so neat. So each new branch is turned by a little more: by chance, up to "
        "10° to either side. That is the **jitter**.\n\n"
        "A branch leans from where its parent points. So what chance did to the parent, its children "
        "carry on, and one change near the trunk turns a whole bough.\n\n"
        "Each number of chance is worked out from the branch’s own number and the **seed**, a whole "
        "number that belongs to the experiment. So the same seed grows the same tree, each time that "
        "you go back to the start.\n\n"
        "A variable or two are enough for quite other patterns. The **gallery** has some; from one "
        "of them, go on by yourself.");
    step.explanation = randomnessExplanation();
    step.tries = randomnessTries();
    step.scene = randomness::setUp;
    step.measures = {countMeasure()};
    step.presets = galleryFor(step);
    return step;
}

Step towardsPointerStep()
{
    Step step = bentStep("towards_pointer", Text::tr("To the pointer"), {formula()});
    step.narration = Text::tr(
        "Hold the button down: every branch turns to the pointer. The trunk turns first. Then its "
        "children move to where it ends now, turn in their turn, and move theirs: from the trunk to the "
        "twigs.\n\n"
        "The tutorial takes the line from the branch’s end to the pointer, and its code **adds** "
        "the end where the text means the distance between the two. That slip makes it work: the branch "
        "comes round in a few frames. With a minus it would flip to and fro as soon as the pointer is "
        "nearer than two lengths.\n\n"
        "**Corrected** takes the line from the branch’s origin, so one frame will do. The two dashed "
        "lines show what each formula wants of the branch next to the pointer.");
    step.explanation = towardsPointerExplanation();
    step.tries = towardsPointerTries();
    step.codeTasks = towardsPointerCodeTasks();
    step.scene = towards_pointer::setUp;
    step.overlays = aimByBothFormulas;
    return step;
}

Step windStep()
{
    Step step = bentStep("wind", Text::tr("Wind"), {formula(), ease()});
    step.narration = Text::tr(
        "Wind blows **away** from you, and nothing bends at once. Each frame a branch turns by the missing "
        "angle divided by **ease**, 8: fast at first, then slower. Within 1° it stays.\n\n"
        "From an angle of −170° to one of 170° it is 20° the short way round, not "
        "340°. So a way past **180°, to either side**, is taken the other way round.\n\n"
        "The published code differs in two places. It adds the end point to the pointer where the way "
        "between the two is meant, so it blows to a wrong side when the pointer is near. And its second "
        "test has 360 for 180, so some branches take the long way. The dashed lines show both winds at "
        "the branch next to the pointer. Nothing brings the tree back yet.");
    step.explanation = windExplanation();
    step.tries = windTries();
    step.scene = wind::setUp;
    return step;
}

Step restStep()
{
    Step step = bentStep("rest", Text::tr("Back to rest"), {formula(), ease()});
    step.narration = Text::tr(
        "Each branch keeps a second angle: the one at which it grew, **rest**. In every frame, wind or "
        "not, it turns back by the missing angle divided by **ease**. It is the formula of the wind with "
        "another target.\n\n"
        "While you hold the button both act, one after the other: first the whole tree returns, then "
        "the wind bends it. Both take an eighth of what they miss, so a branch stays about half-way "
        "between the two.\n\n"
        "Let go, and an eighth of the way is left out each frame: after 5 frames half of the bend is "
        "left. Within 1° a branch stays where it is. Nothing swings past its rest, as "
        "nothing here has a velocity.");
    step.explanation = restExplanation();
    step.tries = restTries();
    step.codeTasks = restCodeTasks();
    step.scene = rest::setUp;
    return step;
}

Step distanceStep()
{
    Step step = bentStep("distance", Text::tr("Distance"), {formula(), ease()});
    step.narration = Text::tr(
        "Close to you the wind should be strong, and far away weak. So the 8 in the wind’s formula gives "
        "way to the **distance** between the pointer and the branch’s end: at 100 px a branch turns by "
        "a hundredth of the missing angle each frame. Its way back is still an eighth, so far "
        "branches hardly bend.\n\n"
        "Nearer than 1 px that would be more than all of it. **Corrected** stops at the wind’s "
        "angle, and with the pointer on the very end it takes a direction that belongs to the branch. The "
        "published code shoots past, and divides by 0 there.\n\n"
        "Its distance is in the branch’s own measure, too: for a branch half as large it counts twice.");
    step.explanation = distanceExplanation();
    step.tries = distanceTries();
    step.scene = distance::setUp;
    return step;
}

Step thicknessStep()
{
    Step step = bentStep("thickness", Text::tr("Thickness"), {formula(), windStrength(), ease()});
    step.narration = Text::tr(
        "Thick branches resist. The distance is multiplied by the branch’s **scale twice**: a twig of "
        "0.2 has 0.04 of the trunk’s resistance, so it turns 25 times as fast. Then all of it "
        "is divided by **wind**, 5.\n\n"
        "The tutorial says that dividing by 5 decreases the strength of the wind. But its variable "
        "`strength` divides the bend, so a smaller one bends more: 5 makes the wind **five times "
        "stronger**.\n\n"
        "Where distance × scale² / 5 is less than 1, the published code turns a twig by more than "
        "the missing angle, past the wind and back. That is much of the quiver near the pointer. "
        "**Corrected** stops at the wind’s angle.");
    step.explanation = thicknessExplanation();
    step.tries = thicknessTries();
    step.scene = thickness::setUp;
    return step;
}

Step turbulenceStep()
{
    Step step = bentStep("turbulence", Text::tr("Turbulence"),
                         {formula(), windStrength(), turbulenceAngle(), ease()});
    step.interactions.push_back(Interaction::gust);
    step.narration = Text::tr(
        "Real wind is never steady. Once a frame, chance turns the wind’s angle by up to 20° to "
        "either side, **the same for all branches**. Twigs follow at once, so they tremble. The trunk is "
        "slow: for it, the changes of many frames cancel.\n\n"
        "Chance is worked out from the seed and the frame’s number. So when you go back in time, "
        "the same gusts come again. An experiment file can give a frame’s turbulence itself, as "
        "a `gust` in degrees.\n\n"
        "This is where the tutorial ends. It moves **angles**: they have no velocity, so this tree never "
        "swings past its rest. The last step is ours. Try the **gallery** in this wind first.");
    step.explanation = turbulenceExplanation();
    step.tries = turbulenceTries();
    step.scene = turbulence::setUp;
    return step;
}

Step realSwayStep()
{
    Parameter k = stiffness(0.05);
    k.help = Text::tr("How hard a joint turns its branch back: for a lone trunk, this share of its bend "
                      "each frame.");
    k.sliderMax = 0.3;
    Parameter damp = damping(0.96);
    damp.help = Text::tr("The share of its spin that every branch keeps each frame. 1 keeps it all.");
    Step step =
        bentStep("real_sway", Text::tr("A real sway"), {k, damp, windStrength(), gustSpeed(), gusts()});
    step.method = QStringLiteral("semi_implicit_euler");
    step.narration = Text::tr(
        "Now every joint is a **spring that turns**: its torque is its stiffness times its twist. The "
        "branch feels it one way, its parent **the opposite way**. That is how a gust in the twigs "
        "moves the trunk.\n\n"
        "A branch has a **spin**, in degrees per frame. Its inertia is its own, plus what it carries at its "
        "end; its stiffness is k × inertia / scale. So a lone trunk is the spring of lesson 1, and thin "
        "branches swing faster.\n\n"
        "Wind pushes by the sine of the angle between branch and wind. A gust runs outwards at **gust "
        "speed**: far branches feel it later. Let go, and the tree swings past its rest.\n\n"
        "With these values a step can be up to 3.1 frames long. Without damping and wind the energy "
        "stays.");
    step.explanation = realSwayExplanation();
    step.tries = realSwayTries();
    step.scene = real_sway::setUp;
    step.overlays = gustFromPointer;
    for (const Measure &energy : energyMeasures())
        step.measures.push_back(energy);
    return step;
}

}
