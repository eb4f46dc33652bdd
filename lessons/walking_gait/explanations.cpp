#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace walking_gait {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(WalkingGait)
};

/// Where some hints begin.
QString hintCarrySideways()
{
    return Text::tr("Press **Space**, take the large disc, and carry it slowly to one side of the picture.");
}

Teaching bones()
{
    return {"bones",
            Text::tr("A bone gives each foot an angle of its own: one place, and not a ring of places."),
            {
                Text::tr("Press **Space**. Take the small disc on the left, carry it past the body to the "
                         "right, let go, and wait."),
                hintCarrySideways(),
                Text::tr("Stop, and press **Shift+→** once: the springs come first."),
            },
            {{Text::tr("Bone"), Text::tr("bone|bones"),
              Text::tr("An angle that belongs to a foot: it says on which side of the body the foot has its "
                       "place.")}},
            {}};
}

Teaching legs()
{
    return {
        "legs",
        Text::tr("A leg is a line that is drawn anew for each picture; nothing feels it."),
        {
            Text::tr("Type 100 into the field beside **Leg**, press **Space**, and wait."),
            Text::tr("Press **Space**, take a small disc, pull it to the upper edge of the picture, and let "
                     "go."),
        },
        {},
        {}};
}

Teaching feetBelow()
{
    return {"feet_below",
            Text::tr("One number that is added to y moves all places below the body."),
            {
                Text::tr("Type 0 into the field beside **Drop**, press **Space**, and wait."),
                Text::tr("y points down, so above the body is below 0: type −50 beside **Drop**, press "
                         "**Space**, and wait."),
                hintCarrySideways(),
            },
            {},
            {}};
}

Teaching curvedLegs()
{
    return {
        "curved_legs",
        Text::tr("A third point bends a leg, and because it is only drawn, the run stays the same."),
        {
            Text::tr("Type 0 into the field beside **Curve**, and look at the legs."),
            Text::tr("Press **Space**, carry the body, and stop. Drag the timeline back to the left, type "
                     "another **Curve**, and play on for a second."),
            Text::tr("Type −30 into the field beside **Curve**."),
        },
        {{Text::tr("Curve"), Text::tr("curve"),
          Text::tr("A line that is bent by a third point: it leaves one end towards that point, and comes "
                   "to the other end from there. (Its name is Bézier curve.)")}},
        {}};
}

Teaching swing()
{
    return {
        "swing",
        Text::tr("A clock turns the places of all feet, and each foot runs after its place."),
        {
            Text::tr("Type −0.05 into the field beside **Speed**, press **Space**, and wait three "
                     "seconds."),
            Text::tr("A foot goes farthest when the clock turns about as fast as the foot swings by "
                     "itself. Type 0.45 beside **Speed**, press **Space**, and touch nothing."),
            hintCarrySideways(),
        },
        {{Text::tr("Gait clock"), Text::tr("clock|one clock"),
          Text::tr("An angle that grows by the same amount each frame. Every foot adds it to the angle of "
                   "its bone, so all of them go round in one rhythm.")},
         {Text::tr("Gait"), Text::tr("gait|gaits"),
          Text::tr("The order and the rhythm in which a creature moves its feet.")}},
        {{Text::tr("Why sine and cosine in a clock?"),
          Text::tr("A point on a circle has two numbers. Walk round a circle of radius 1, and call the way "
                   "along it the angle a. Then\n\n"
                   "`x = cos a,  y = sin a`\n\n"
                   "That is what cos and sin **are**. For a circle of 50 px round a middle:\n\n"
                   "`x = mx + 50 × cos a`\n\n"
                   "`y = my + 50 × sin a`\n\n"
                   "The clock only makes a larger, frame by frame. x then swings to and fro, and y does so "
                   "a quarter of a turn later. Half a turn more, π, puts the other foot on the far side: "
                   "cos and sin change their sign.")}}};
}

Teaching bodyPulled()
{
    return {
        "body_pulled",
        Text::tr("Each leg pulls foot and body just as hard, so legs alone get nowhere."),
        {
            Text::tr("Press **Space**, take a small disc, pull it to the upper edge of the picture, and let "
                     "go."),
            Text::tr("Type 1 into the field beside **Damping**. Press **Space**, take the large disc, swing "
                     "it, and let go on the way. Then wait four seconds."),
            Text::tr("Press **Space**, take a small disc, and hold it for two seconds."),
        },
        {},
        {}};
}

Teaching ground()
{
    return {
        "ground",
        Text::tr("A foot that stands cannot give way, so the body does: it walks."),
        {
            Text::tr("Type −0.05 into the field beside **Speed**, press **Space**, and watch it go."),
            Text::tr("Play some seconds. Choose **none** beside **Traction**, and wait five seconds."),
            Text::tr("Type 0.8 into the field beside **Bounce**, and press **Enter**. Go on frame by frame "
                     "with **→** until a "
                     "foot that was on the ground goes up."),
            Text::tr("Press **Space**, take the large disc, lift it near to the upper edge of the picture, "
                     "let go, "
                     "and wait two seconds."),
        },
        {{Text::tr("Traction"), Text::tr("traction"),
          Text::tr("What keeps a foot from sliding on the ground. Without it the ground is like ice.")},
         {Text::tr("Slip"), Text::tr("slips a little"),
          Text::tr("How far a foot slides along the ground while it should stand.")}},
        {}};
}

Teaching moreFeet()
{
    return {"more_feet",
            Text::tr("More feet share the clock, and the body goes up and down less."),
            {
                Text::tr("Type 12 into the field beside **Feet**, press **Space**, and wait seven seconds."),
                Text::tr("Type 0 into the field beside **Spread**, press **Space**, and wait seven seconds."),
                Text::tr("Press **Reset all**. Type 0.3 into the field beside **Speed**. Play three seconds "
                         "and stop. Go on frame by "
                         "frame with **→** until all feet are in the air."),
            },
            {},
            {}};
}

Teaching steering()
{
    return {
        "steering",
        Text::tr("The speed of the clock steers the creature: above 0 to the right, below 0 to the left."),
        {
            Text::tr("Click the picture, press **Space**, and hold **←** for two seconds. Let go when it "
                     "walks to the left, and watch."),
            Text::tr("Press **Space**. Press the mouse button in the picture, and with the button down go "
                     "far to the "
                     "left or right, past the edge of the picture if need be."),
            Text::tr("Press **Space** and hold **←** until its legs hardly move. Or press the mouse button "
                     "far off, and with the button down go straight above or below the body."),
        },
        {},
        {}};
}

Teaching walls()
{
    return {
        "walls",
        Text::tr("Turning round at a wall is a rule for the clock; the wall itself only stops what hits "
                 "it."),
        {
            Text::tr("Choose **walk on** beside **At a wall**, press **Space**, and wait until it has walked "
                     "against a wall for a while."),
            Text::tr("Choose **turn** beside **At a wall**. Type 200 beside **Left wall** and 340 beside "
                     "**Right wall**, press **Space**, and "
                     "wait until it turns."),
            Text::tr("Press **Space**, take the large disc, swing it towards a wall, and let go on the "
                     "way."),
        },
        {},
        {}};
}

Teaching company()
{
    return {
        "company",
        Text::tr("A push that both feel makes no momentum; a push that one feels makes it from nothing."),
        {
            Text::tr("Press **Space**, take the large disc of one creature, and carry it onto the other "
                     "one."),
            Text::tr("Choose **one** beside **Felt by**, press **Space**, and wait until two bodies "
                     "touch."),
            Text::tr("Type 5 into the field beside **Creatures**, press **Space**, and wait ten seconds."),
        },
        {},
        {}};
}

}

std::vector<Teaching> teaching()
{
    return {bones(),  legs(),     feetBelow(), curvedLegs(), swing(),  bodyPulled(),
            ground(), moreFeet(), steering(),  walls(),      company()};
}

}
