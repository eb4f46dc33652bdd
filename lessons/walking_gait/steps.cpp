#include "steps.h"

#include "checks.h"
#include "code_tasks.h"
#include "explanations.h"
#include "lessons/api/parameters.h"
#include "lessons/walking_gait/text.h"
#include "parameters.h"
#include "scenes.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace walking_gait {

namespace {

Step newStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("walking_gait", id, title);
    step.parameters = {stiffness(), damping(), leg()};
    return step;
}

/// Returns a step whose creature walks on the ground.
Step newGroundStep(const char *id, const QString &title)
{
    Step step = lessons::makeStep("walking_gait", id, title);
    step.view = groundView;
    step.isFootDown = isPlanted;
    step.overlays = footTargets;
    step.measures = {walkingSpeed(), slip()};
    return step;
}

/// Appends the parameters that all steps on the ground share.
void addCommonParameters(Step &step)
{
    step.addParameters({lessons::gravity(), footBounce(), traction(), stiffness(0.1), damping(), leg(),
                        drop(), curve(), lessons::ground()});
}

}

Step bonesStep()
{
    Step step = newStep("bones", Text::tr("Bones"));
    step.narration = Text::tr(
        "Until now a foot was content anywhere on a ring round the body: a rag doll. Now each foot has a "
        "**bone**: an angle of its own. It belongs **leg** pixels from the body at that angle, and a plain "
        "spring pulls it there. A cross shows the place.\n\n"
        "Angles are in radians. Foot 0 has the angle 0; foot 1 has π, half a turn on. The code "
        "**subtracts** the bone from the body, so foot 0 belongs on the **left**.\n\n"
        "(The tutorial behind this lesson says right, and in one passage that the leg is 75 px. Its code "
        "has left and 50, and its code is what runs here.)\n\n"
        "The body is a handle again: only your hand moves it.");
    step.explanation = bonesExplanation();
    step.tries = bonesTries();
    step.codeTasks = bonesCodeTasks();
    step.scene = bones::setUp;
    step.view = plainView;
    step.overlays = boneLines;
    return step;
}

Step legsStep()
{
    Step step = newStep("legs", Text::tr("Legs"));
    step.narration = Text::tr(
        "A **leg** is a line from the body to a foot. It is made anew for each picture, from where body and "
        "foot are at that moment. Nothing feels it: the code that moves the feet is the same as before.\n\n"
        "Still it tells you something: how far the foot is from the body. At rest each line is as long as "
        "**leg** "
        "says, 50 px. While a foot swings, you see it stretch and shrink.");
    step.explanation = legsExplanation();
    step.tries = legsTries();
    step.scene = legs::setUp;
    step.view = straightLegsView;
    step.overlays = footTargets;
    return step;
}

Step feetBelowStep()
{
    Step step = newStep("feet_below", Text::tr("Feet below the body"));
    step.parameters.push_back(drop());
    step.narration = Text::tr(
        "Feet belong below a body. One number does it: **drop** moves the place of every foot straight "
        "down, by 50 px. (y points down, so it is added.)\n\n"
        "It comes after the bone: it does not turn with the leg's angle, and is the same for all feet.\n\n"
        "Each place is now 50 px to the side and 50 px down: 70.7 px from the body. The feet start in their "
        "places, so nothing moves until you move something.");
    step.explanation = feetBelowExplanation();
    step.tries = feetBelowTries();
    step.scene = feet_below::setUp;
    step.view = straightLegsView;
    step.overlays = footTargets;
    return step;
}

Step curvedLegsStep()
{
    Step step = newStep("curved_legs", Text::tr("Curved legs"));
    step.parameters.insert(step.parameters.begin(), curve()); // the topic of the step comes first
    step.addParameters({drop()});
    step.narration = Text::tr(
        "Two straight twigs are no legs. A **curve** needs one more point: the cross above each foot, "
        "**curve** pixels up. The leg leaves the foot towards that point and comes to the body from there. "
        "Halfway it is a quarter of the way to the foot, a quarter to the body, and half to the cross.\n\n"
        "The point is only drawn. The springs do not know of it, so the run is the same for every curve: "
        "the ghost proves it.");
    step.explanation = curvedLegsExplanation();
    step.tries = curvedLegsTries();
    step.scene = curved_legs::setUp;
    step.view = curvedLegsView;
    step.overlays = legControlPoints;
    return step;
}

Step swingStep()
{
    Step step = newStep("swing", Text::tr("Swing"));
    step.addParameters({speed(), drop(), curve()});
    step.narration = Text::tr(
        "Now the places move. The creature gets **one clock** that turns by **speed** each frame, last of "
        "all. Every foot adds it to its own angle. So the places go round, clockwise, half a turn apart, "
        "and each foot runs after its place.\n\n"
        "At 0.05 rad a frame a full turn (2π, 6.28 rad) takes 126 frames.\n\n"
        "A foot is on a spring: it doesn't follow exactly. At this speed it goes round on 50.6 px where its "
        "place is 50 px out. Near the speed at which it would swing by itself, it goes much farther.");
    step.explanation = swingExplanation();
    step.tries = swingTries();
    step.codeTasks = swingCodeTasks();
    step.scene = swing::setUp;
    step.view = curvedLegsView;
    step.overlays = targetsOnCircle;
    step.measures = {swingWidth()};
    return step;
}

Step bodyPulledStep()
{
    Step step = newStep("body_pulled", Text::tr("The body is pulled, too"));
    step.addParameters({speed(), drop(), curve()});
    step.narration = Text::tr(
        "What pulls is pulled back, just as hard, the other way. That needs no new formula: each leg's pull "
        "goes onto its foot, and the **opposite** goes onto the body, in the same moment.\n\n"
        "So what the feet gain, the body loses. All velocities added up are the **momentum**, and no leg "
        "can change it. Only damping takes from it, and your hand.\n\n"
        "Let it run: the legs pull the body left and right just as hard at every moment. It stays where it "
        "is. Legs alone get nowhere: there must be something to stand on.");
    step.explanation = bodyPulledExplanation();
    step.tries = bodyPulledTries();
    step.codeTasks = bodyPulledCodeTasks();
    step.scene = body_pulled::setUp;
    step.view = curvedLegsView;
    step.overlays = centreAndTargets;
    step.measures = {momentumOfAll()};
    return step;
}

Step groundStep()
{
    Step step = newStep("ground", Text::tr("Ground"));
    step.parameters = {speed(),        lessons::gravity(), footBounce(), traction(),
                       stiffness(0.1), damping(),          leg(),        drop(),
                       curve(),        lessons::ground()};
    step.narration = Text::tr(
        "Gravity pulls everything down, and the **ground** holds the feet. Only the feet: they hold the "
        "body. A foot below the ground is put back onto it, and its velocity becomes 0, sideways, too. That "
        "is its **traction**.\n\n"
        "Now the foot stands. Its leg still pulls, and only the body can give way: it walks, about 150 px "
        "in each turn of the clock. A negative **speed** walks left. Without traction it treads on the "
        "spot.\n\n"
        "A standing foot is stopped **after** it moved. So it slips a little in each frame, 0.4 px on the "
        "average. In steps of half a frame it slips 0.25 px, and walks 1.4 px a frame instead of 1.2.\n\n"
        "From here on k is 0.1.");
    step.explanation = groundExplanation();
    step.tries = groundTries();
    step.codeTasks = groundCodeTasks();
    step.scene = walking_gait::ground::setUp;
    step.view = groundView;
    step.isFootDown = isPlanted;
    step.overlays = footTargets;
    step.measures = {walkingSpeed(), slip()};
    return step;
}

Step moreFeetStep()
{
    Step step = newGroundStep("more_feet", Text::tr("More feet"));
    step.addParameters({legCount(), spread(), speed()});
    addCommonParameters(step);
    step.narration = Text::tr(
        "More feet need no new code: the loop gives each an angle, and they share the clock. Foot i of n "
        "belongs i/n of a full turn behind foot 0. **spread** makes that more or less than a full turn.\n\n"
        "Two feet carry the body up and down by 55 px. With five it is 4 px, with twelve 1 px: some foot is "
        "always on its way down. They walk faster, too, 1.4 px a frame instead of 1.2.\n\n"
        "At a spread of 0 all step together. The body falls and rises, and it gets nowhere.");
    step.explanation = moreFeetExplanation();
    step.tries = moreFeetTries();
    step.scene = more_feet::setUp;
    step.presets = gaits();
    return step;
}

Step steeringStep()
{
    Step step = newGroundStep("steering", Text::tr("Steering"));
    step.addParameters({speed(), top(), change()});
    addCommonParameters(step);
    step.narration = Text::tr(
        "The clock's speed is a number like any other, so it can change while the creature walks. Above 0 "
        "it walks right, below 0 left, at 0 it stands.\n\n"
        "**Arrow keys**, while it plays: each frame that → is down adds **change** to the speed, ← takes as "
        "much away.\n\n"
        "**Pointer:** while its button is down it sets the speed: 200 px to the right of the body ask for "
        "**top speed**, half as far for half of it, and to the left it is negative.\n\n"
        "Neither gets past the top speed, 0.15 either way. Let go, and the creature keeps the speed that it "
        "has.");
    step.explanation = steeringExplanation();
    step.tries = steeringTries();
    step.scene = steering::setUp;
    step.interactions = {Interaction::drag, Interaction::pointer, Interaction::keys};
    step.measures.push_back(clockSpeed());
    return step;
}

Step wallsStep()
{
    Step step = newGroundStep("walls", Text::tr("Walls to bump into"));
    step.addParameters({atWall()});
    step.addParameters(sideWalls()); // the room is the topic of the step
    step.addParameters({speed(), top(), change()});
    addCommonParameters(step);
    step.narration = Text::tr(
        "Two walls, as in the lesson before, for feet and body. Where an edge is past a wall, it is put "
        "back, and the velocity across the wall becomes 0.\n\n"
        "The creature **turns round** when any part of it touches a wall: the clock's speed gets the sign "
        "that leads away. It is a rule, not a force: the wall only stops what hits it. With **at wall** on "
        "*walk on* it walks against the wall for good. Its standing feet then slip 1.1 px a frame, more than "
        "twice as much as on its way.\n\n"
        "You can steer it, as before: with the arrow keys, or with the pointer while its button is down.");
    step.explanation = wallsExplanation();
    step.tries = wallsTries();
    step.scene = walls::setUp;
    step.view = roomView;
    step.interactions = {Interaction::drag, Interaction::pointer, Interaction::keys};
    step.measures.push_back(clockSpeed());
    return step;
}

Step companyStep()
{
    Step step = newGroundStep("company", Text::tr("Company"));
    step.addParameters({creatures(), push(), distance(), feltBy(), atWall(), speed()});
    step.addParameters(sideWalls());
    addCommonParameters(step);
    step.narration = Text::tr(
        "Several creatures, each with its own clock. They start towards each other, out of step.\n\n"
        "Two bodies closer than **distance** push each other apart, by **push** times the missing distance: "
        "a spring that never pulls. Legs meet nothing.\n\n"
        "Each push is felt by **both**, the opposite way, in the same moment. So all pushes add up to 0, "
        "and two creatures that meet share their momentum out anew; the push makes none and loses none. "
        "(The ground does: it stops feet.) With **felt by** on one, the second feels nothing. Then each "
        "push makes momentum from nothing.");
    step.explanation = companyExplanation();
    step.tries = companyTries();
    step.scene = company::setUp;
    step.view = roomView;
    step.measures = {slip(), sumOfPushes()};
    return step;
}

}
