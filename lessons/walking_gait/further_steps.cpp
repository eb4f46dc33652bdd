#include "steps.h"

#include "lessons/api/parameters.h"
#include "measures.h"
#include "parameters.h"
#include "picture.h"
#include "scenes.h"
#include "tries.h"

#include <QCoreApplication>

using namespace lessons;

namespace walking_gait {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(WalkingGait)
};

Step stepOf(const char *id, const QString &title)
{
    Step step = lessons::stepCalled("walking_gait", id, title);
    step.setUp.file = "lessons/walking_gait/further_scenes.cpp";
    step.look = onGround;
    step.stands = stands;
    step.guides = places;
    step.measures = {walkingSpeed(), slip()};
    return step;
}

/// What all steps on the ground have, after what is a step's own.
void addCommon(Step &step)
{
    step.addParameters({lessons::gravity(), footBounce(), traction(), stiffness(0.1), damping(), leg(),
                        drop(), curve(), lessons::ground()});
}

/// `left` and `right`.
std::vector<Parameter> sideWalls()
{
    std::vector<Parameter> all = room();
    all.pop_back(); // the floor
    return all;
}

std::vector<Preset> gaits()
{
    return {
        {Text::tr("Centipede"),
         Text::tr("Twelve feet, one after the other: the body glides."),
         {{"feet", 12.0}}},
        {Text::tr("Trot"),
         Text::tr("Four feet in two pairs: it bobs like one with two feet."),
         {{"feet", 4.0}, {"spread", 720.0}}},
        {Text::tr("Limp"),
         Text::tr("Three feet close behind each other, then a pause."),
         {{"feet", 3.0}, {"spread", 180.0}}},
        {Text::tr("Runner"),
         Text::tr("A fast clock: no foot touches the ground for long."),
         {{"feet", 4.0}, {"speed", 0.15}}},
    };
}

}

Step moreFeetStep()
{
    Step step = stepOf("more_feet", Text::tr("More feet"));
    step.addParameters({legCount(), spread(), speed()});
    addCommon(step);
    step.narration = Text::tr(
        "More feet need no new code: the loop gives each an angle, and they share the clock. Foot i of n "
        "belongs i/n of a full turn behind foot 0. **spread** makes that more or less than a full turn.\n\n"
        "Two feet carry the body up and down by 55 px. With five it is 4 px, with twelve 1 px: some foot is "
        "always on its way down. They walk faster, too, 1.4 px a frame instead of 1.2.\n\n"
        "At a spread of 0 all step together. The body falls and rises, and it gets nowhere.");
    step.tries = moreFeetTries();
    step.scene = more_feet::setUp;
    step.presetGallery = gaits();
    return step;
}

Step steeringStep()
{
    Step step = stepOf("steering", Text::tr("Steering"));
    step.addParameters({speed(), top(), change()});
    addCommon(step);
    step.narration = Text::tr(
        "The clock's speed is a number like any other, so it can change while the creature walks. Above 0 "
        "it walks right, below 0 left, at 0 it stands.\n\n"
        "**Arrow keys**, while it plays: each frame that → is down adds **change** to the speed, ← takes as "
        "much away.\n\n"
        "**Pointer:** while its button is down it sets the speed: 200 px to the right of the body ask for "
        "**top speed**, half as far for half of it, and to the left it is negative.\n\n"
        "Neither gets past the top speed, 0.15 either way. Let go, and the creature keeps the speed that it "
        "has.");
    step.tries = steeringTries();
    step.scene = steering::setUp;
    step.does = {Does::hand, Does::pointer, Does::keys};
    step.measures.push_back(clockSpeed());
    return step;
}

Step wallsStep()
{
    Step step = stepOf("walls", Text::tr("Walls to bump into"));
    step.addParameters({atWall()});
    step.addParameters(sideWalls()); // the room is what the step is about
    step.addParameters({speed(), top(), change()});
    addCommon(step);
    step.narration = Text::tr(
        "Two walls, as in the lesson before, for feet and body. Where an edge is past a wall, it is put "
        "back, and the velocity across the wall becomes 0.\n\n"
        "The creature **turns round** when any part of it touches a wall: the clock's speed gets the sign "
        "that leads away. It is a rule, not a force: the wall only stops what hits it. With **at wall** on "
        "*walk on* it walks against the wall for good. Its standing feet then slip 1.1 px a frame, more than "
        "twice as much as on its way.\n\n"
        "You can steer it, as before: with the arrow keys, or with the pointer while its button is down.");
    step.tries = wallsTries();
    step.scene = walls::setUp;
    step.look = inRoom;
    step.does = {Does::hand, Does::pointer, Does::keys};
    step.measures.push_back(clockSpeed());
    return step;
}

Step companyStep()
{
    Step step = stepOf("company", Text::tr("Company"));
    step.addParameters({creatures(), push(), distance(), feltBy(), atWall(), speed()});
    step.addParameters(sideWalls());
    addCommon(step);
    step.narration = Text::tr(
        "Several creatures, each with a clock of its own. They start towards each other, out of step.\n\n"
        "Two bodies closer than **distance** push each other apart, by **push** times what is missing: a "
        "spring that never pulls. Legs meet nothing.\n\n"
        "Each push is felt by **both**, the opposite way, in the same moment. So all pushes add up to 0, "
        "and two creatures that meet share their momentum out anew; the push makes none and loses none. "
        "(The ground does: it stops feet.) With **felt by** on one, the second feels nothing. Then each "
        "push makes momentum from nothing.");
    step.tries = companyTries();
    step.scene = company::setUp;
    step.look = inRoom;
    step.measures = {slip(), sumOfPushes()};
    return step;
}

}
