#include "explanations.h"
#include "lessons/walking_gait/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace walking_gait {

Explanation bonesExplanation()
{
    return {
        .learnt =
            Text::tr("A bone gives each foot an angle of its own: one place, and not a ring of places."),
        .terms =
            {
                {Text::tr("Bone"), Text::tr("bone|bones"),
                 Text::tr(
                     "An angle that belongs to a foot: it says on which side of the body the foot has its "
                     "place.")},
            },
    };
}

Explanation legsExplanation()
{
    return {
        .learnt = Text::tr("A leg is a line that is drawn anew for each picture; nothing feels it."),
    };
}

Explanation feetBelowExplanation()
{
    return {
        .learnt = Text::tr("One number that is added to y moves all places below the body."),
    };
}

Explanation curvedLegsExplanation()
{
    return {
        .learnt =
            Text::tr("A third point bends a leg, and because it is only drawn, the run stays the same."),
        .terms =
            {
                {Text::tr("Curve"), Text::tr("curve"),
                 Text::tr(
                     "A line that is bent by a third point: it leaves one end towards that point, and comes "
                     "to the other end from there. (Its name is Bézier curve.)")},
            },
    };
}

Explanation swingExplanation()
{
    return {
        .learnt = Text::tr("A clock turns the places of all feet, and each foot runs after its place."),
        .terms =
            {
                {Text::tr("Gait clock"), Text::tr("clock|one clock"),
                 Text::tr(
                     "An angle that grows by the same amount each frame. Every foot adds it to the angle of "
                     "its bone, so all of them go round in one rhythm.")},
                {Text::tr("Gait"), Text::tr("gait|gaits"),
                 Text::tr("The order and the rhythm in which a creature moves its feet.")},
            },
        .whys =
            {
                {Text::tr("Why sine and cosine in a clock?"),
                 Text::tr(
                     "A point on a circle has two numbers. Walk round a circle of radius 1, and call the way "
                     "along it the angle a. Then\n\n"
                     "`x = cos a,  y = sin a`\n\n"
                     "That is what cos and sin **are**. For a circle of 50 px round a middle:\n\n"
                     "`x = mx + 50 × cos a`\n\n"
                     "`y = my + 50 × sin a`\n\n"
                     "The clock only makes a larger, frame by frame. x then swings to and fro, and y does so "
                     "a quarter of a turn later. Half a turn more, π, puts the other foot on the far side: "
                     "cos and sin change their sign.")},
            },
    };
}

Explanation bodyPulledExplanation()
{
    return {
        .learnt = Text::tr("Each leg pulls foot and body just as hard, so legs alone get nowhere."),
    };
}

Explanation groundExplanation()
{
    return {
        .learnt = Text::tr("A foot that stands cannot give way, so the body does: it walks."),
        .terms =
            {
                {Text::tr("Traction"), Text::tr("traction"),
                 Text::tr(
                     "What keeps a foot from sliding on the ground. Without it the ground is like ice.")},
                {Text::tr("Slip"), Text::tr("slips a little"),
                 Text::tr("How far a foot slides along the ground while it should stand.")},
            },
    };
}

Explanation moreFeetExplanation()
{
    return {
        .learnt = Text::tr("More feet share the clock, and the body goes up and down less."),
    };
}

Explanation steeringExplanation()
{
    return {
        .learnt = Text::tr(
            "The speed of the clock steers the creature: above 0 to the right, below 0 to the left."),
    };
}

Explanation wallsExplanation()
{
    return {
        .learnt =
            Text::tr("Turning round at a wall is a rule for the clock; the wall itself only stops what hits "
                     "it."),
    };
}

Explanation companyExplanation()
{
    return {
        .learnt =
            Text::tr("A push that both feel makes no momentum; a push that one feels makes it from nothing."),
    };
}

}
