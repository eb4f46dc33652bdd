#include "steps.h"

#include "cases.h"
#include "checks.h"
#include "explanations.h"
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
Step newStep(const char *id, const QString &title, const QRectF &stage, const Companion &companion)
{
    Step step = lessons::makeStep("hard_cases", id, title);
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
        "limit", Text::tr("The limit of a step"), QRectF(10, 130, 520, 110),
        {.method = "implicit_midpoint", .caption = Text::tr("Implicit midpoint"), .offset = {0, 150}});
    step.addParameters({stiffnessUpTo(4.01, 6.0), damping(1.0)});
    step.narration = Text::tr(
        "A step asks for the pull once, and then goes straight on. If the spring is too stiff, it goes past "
        "the middle, and farther out than it came from. The next pull is stronger still.\n\n"
        "Without damping this begins at exactly **k h² = 4**: with steps of one frame, at a stiffness "
        "of 4. There the foot comes out on the other side with all its speed. Here k is 4.01.\n\n"
        "A smaller step moves the limit: half of it bears **four times** the stiffness. Damping moves it, "
        "too: "
        "for steps of a frame to k = 2 (1 + damp) / damp.\n\n"
        "**Implicit midpoint**, below, asks for the pull half-way, where it does not know the place yet, and "
        "solves for it. It has no such limit.\n\n"
        "The small **gauge** shows how near you are.");
    step.method = "semi_implicit_euler";
    step.explanation = limitExplanation();
    step.tries = limitTries();
    step.scene = limit::setUp;
    step.overlays = turningPoints;
    return step;
}

Step runawayStep()
{
    Step step = newStep(
        "runaway", Text::tr("The runaway pair"), QRectF(225, 150, 140, 140),
        {.method = "semi_implicit_euler", .caption = Text::tr("Semi-implicit Euler"), .offset = {150, 0}});
    step.addParameters({stiffnessUpTo(0.3, 1.0), damping(0.9), radius()});
    step.narration = Text::tr(
        "A foot and a body pull each other. Nothing pushes from outside, so **the middle between them has to "
        "stay where it is**: at the cross.\n\n"
        "The printed rule moves the foot first. Then the body looks where the foot is **now**, and feels "
        "another pull than the foot felt. What the two give each other is not equal any more: the pair makes "
        "itself a push out of nothing, each frame. With k = 0.3 and damping 0.9 that is more than damping "
        "takes, and the pair never comes to rest.\n\n"
        "At k = 0.2 it does come to rest, but in a wrong place.\n\n"
        "**Semi-implicit Euler**, on the right, is the same formula. It only takes all pulls first, and "
        "moves "
        "all bodies then.");
    step.explanation = runawayExplanation();
    step.tries = runawayTries();
    step.scene = runaway::setUp;
    step.overlays = centreOverlays;
    return step;
}

Step manyFeetStep()
{
    Step step =
        newStep("many_feet", Text::tr("Too many feet"), QRectF(195, 115, 150, 160),
                {.method = "backward_euler", .caption = Text::tr("Backward Euler"), .offset = {160, 0}});
    step.addParameters({feetUpTo(60, 100), stiffnessUpTo(0.2, 1.0), damping(0.85), radius()});
    step.narration = Text::tr(
        "A stiffness of 0.2 is soft. But the body feels **all its feet at once**: sixty soft springs make "
        "one that is stiff.\n\n"
        "In any direction about half of the feet count, and the feet give way a little. So the pair of body "
        "and feet swings like a spring of stiffness k (1 + feet / 2). With damping 0.85 the limit "
        "is 4.35, which is about 41 feet. At rest, that is: legs that are out of their length make it "
        "worse, so 38 feet hold here, and 41 do not.\n\n"
        "**Backward Euler**, on the right, looks for the place where the pulls *of the new place* lead to. "
        "No number of feet is too many for it.");
    step.method = "semi_implicit_euler";
    step.explanation = manyFeetExplanation();
    step.tries = manyFeetTries();
    step.scene = many_feet::setUp;
    return step;
}

Step onePlaceStep()
{
    Step step = newStep(
        "one_place", Text::tr("All in one place"), QRectF(195, 115, 150, 160),
        {.method = "semi_implicit_euler", .caption = Text::tr("Semi-implicit Euler"), .offset = {160, 0}});
    step.addParameters({feetUpTo(5, 24), stiffnessUpTo(0.1, 1.0), damping(0.85), radius()});
    step.narration = Text::tr(
        "Five feet and a body begin in **one place**. Each spring wants to be 50 px long. In which "
        "direction?\n\n"
        "The printed code asks `atan2(0, 0)`, which is 0: to the right, for every foot. So all five go "
        "together, the body goes to the left, and what was five feet is one for ever: nothing tells them "
        "apart any more.\n\n"
        "The rule on the right gives **each pair a direction of its own**: it turns by the golden angle from "
        "one pair to the next, so many feet spread evenly. The two ends of a spring get opposite "
        "directions. It counts nothing but the numbers of the two points, so the same run comes out each "
        "time.\n\n"
        "Every method but the printed one uses it, everywhere.");
    step.explanation = onePlaceExplanation();
    step.tries = onePlaceTries();
    step.scene = one_place::setUp;
    return step;
}

Step stiffStep()
{
    Step step =
        newStep("stiff", Text::tr("Stiff but calm"), QRectF(190, 120, 155, 170),
                {.method = "backward_euler", .caption = Text::tr("Backward Euler"), .offset = {165, 0}});
    step.addParameters({stiffnessUpTo(1000.0, 2000.0), damping(0.9), radius()});
    step.narration = Text::tr(
        "Three legs, each 5000 times as stiff as before: nearly sticks. In one step Semi-implicit Euler "
        "sends the feet 20 000 px away. Some frames later the numbers are too large to write: the run "
        "**stops at the last good frame** and says who went first. Nothing is lost. Go back, and change "
        "something.\n\n"
        "It can be saved by small steps: 1/32 of a frame is too long still, 1/64 holds. That is 64 times the "
        "work, for a motion that nobody sees.\n\n"
        "**Backward Euler** needs one step a frame, at any stiffness. The price: it slows what swings, as if "
        "there were more damping. For what should be stiff and calm that is right; for what should swing, "
        "it is not.");
    step.method = "semi_implicit_euler";
    step.explanation = stiffExplanation();
    step.tries = stiffTries();
    step.scene = stiff::setUp;
    return step;
}

Step contradictionStep()
{
    Step step = newStep(
        "contradiction", Text::tr("Sticks that contradict"), QRectF(180, 95, 180, 200),
        {.method = "semi_implicit_euler", .caption = Text::tr("The same, as sticks"), .offset = {190, 0}});
    step.companion->values = {{"made_of", 1.0}};
    Parameter madeOf =
        choice("made_of", Text::tr("Made of"),
               Text::tr("Whether springs hold the three points, or rigid sticks."), {"springs", "sticks"});
    madeOf.choiceTitles = {Text::tr("springs"), Text::tr("sticks")};
    step.addParameters({madeOf, longest(), stiffnessUpTo(1.5, 3.0), damping(0.9)});
    step.narration = Text::tr(
        "Three lengths: 20, 20 and 200 px. No triangle has them. Whatever moves, something is wrong.\n\n"
        "On the left **springs** pull. What is wrong stays wrong, so they pull for ever, and three springs "
        "of 1.5 are too stiff for a step: in a line they swing like one of 3 k, and the limit is 4.22.\n\n"
        "On the right **sticks** hold. They do not pull: each is made right by *moving* its ends, one after "
        "the other. The last in the list has its length, and the others bear the error. A place cannot be "
        "moved farther than an error is large, so sticks never run away. They come to rest, with a lie "
        "shared "
        "out among them. Its size is in their colour.");
    step.view = triangleView;
    step.method = "semi_implicit_euler";
    step.explanation = contradictionExplanation();
    step.tries = contradictionTries();
    step.scene = contradiction::setUp;
    return step;
}

Step longRunStep()
{
    Step step =
        newStep("long_run", Text::tr("The long run"), QRectF(140, 150, 260, 80),
                {.method = "velocity_verlet", .caption = Text::tr("Velocity Verlet"), .offset = {0, 100}});
    step.addParameters({stiffnessUpTo(0.5, 2.0), damping(1.0)});
    step.narration = Text::tr(
        "Nothing slows this foot. It should swing for ever.\n\n"
        "**Runge–Kutta 4** is the more exact of the two: in the first ten frames it is never more than "
        "1.3 px off, "
        "Velocity Verlet up to 14 px. But its error always points the same way: with steps of a frame, each "
        "of "
        "them takes 0.08 % of the swing. After **851 frames** half is left, after 5000 next to nothing.\n\n"
        "**Velocity Verlet**, below, swings a little too fast. But its steps can be taken back exactly, and "
        "so "
        "nothing is lost, not in ten million frames.\n\n"
        "To go far, type a frame's number into the counter.\n\n"
        "What an error *adds up to* counts for more than how small it is.");
    step.method = "rk4";
    step.explanation = longRunExplanation();
    step.tries = longRunTries();
    step.scene = long_run::setUp;
    step.overlays = turningPoints;
    return step;
}

Step tortureStep()
{
    Step step = lessons::makeStep("hard_cases", "torture", Text::tr("The torture panel"));
    step.addParameters({caseParameter(), caseStiffness()});
    step.narration = Text::tr(
        "Here are all the cases that this program is tested with. Choose one, and a **method** above the "
        "scene, and see what holds.\n\n"
        "A method **claims** what it can hold: that follows from its rule, and is worked out before the run. "
        "The line over the scene says whether it claims this case, and how the run has been so far: within "
        "the "
        "bounds that the case sets, at rest where it should be, or out of bounds, and since when.\n\n"
        "A claim that breaks would be a fault of the program. A case that nobody claims may hold all the "
        "same. What cannot be computed at all is refused, with a sentence.\n\n"
        "Hands, walls and steps belong to a case. If you reach in, it is your own experiment.");
    step.view = caseView;
    step.prepareScript = prepareCase;
    step.note = caseNote();
    step.explanation = tortureExplanation();
    step.tries = tortureTries();
    step.scene = torture::setUp;
    step.interactions = {Interaction::drag, Interaction::pointer, Interaction::target};
    return step;
}

}
