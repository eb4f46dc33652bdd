#include "explanations.h"
#include "lessons/rigid_constraint/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace rigid_constraint {

Explanation pairExplanation()
{
    return {
        .learnt =
            Text::tr("A stick measures its error and moves both ends by half of it: no spring, no velocity."),
        .terms =
            {
                {Text::tr("Stick"), Text::tr("stick|sticks"),
                 Text::tr("A rule that keeps two points at a fixed distance. It does not pull: it puts its "
                          "ends where they belong.")},
                {Text::tr("Constraint"), Text::tr("constraint|constraints"),
                 Text::tr(
                     "A rule that must hold after each frame, whatever moved before: a distance, a wall, "
                     "a joint that bends only so far.")},
                {Text::tr("Error"), Text::tr("the error|error"),
                 Text::tr("Of a stick: how much too long it is, or too short (then it is below 0). Of a run: "
                          "how far it is from the exact motion.")},
            },
        .whys =
            {
                {Text::tr("Why half of the error each?"),
                 Text::tr(
                     "A stick of 100 px is 130 px long. The error is\n\n"
                     "`130 − 100 = 30 px`\n\n"
                     "Both ends move along the stick, towards each other. Together they have to come 30 px, "
                     "so each comes 15:\n\n"
                     "`share of a = w_a / (w_a + w_b)`\n\n"
                     "where w is how easily an end moves: 1 for both here, and 0 for a nail. Two ends that "
                     "are as heavy share alike, and their middle stays where it is.")},
            },
    };
}

Explanation sharedErrorExplanation()
{
    return {
        .learnt = Text::tr("Who takes which share of the error decides who leads and who follows."),
        .terms =
            {
                {Text::tr("Share"),
                 {},
                 Text::tr(
                     "The part of a stick’s error that one of its ends takes, from 0 to 1. The other end "
                     "takes the rest.")},
            },
        .whys =
            {
                {Text::tr("Why does each frame leave share of the error?"),
                 Text::tr(
                     "The pointer puts p0 back each frame. The stick is then wrong by some error e. p0 takes "
                     "share × e, p1 takes the rest:\n\n"
                     "`p1 comes (1 − share) × e nearer`\n\n"
                     "The pointer puts p0 back again. What p0 gave is undone, what p1 came stays. So what is "
                     "left is\n\n"
                     "`e − (1 − share) × e = share × e`\n\n"
                     "At 0.5: a half, a quarter, an eighth. At 1 nothing ever gets better, at 0 one frame is "
                     "enough.")},
            },
    };
}

Explanation triangleExplanation()
{
    return {
        .learnt =
            Text::tr("Each stick makes itself right and its neighbours a little wrong; frame by frame the "
                     "error shrinks."),
    };
}

Explanation listExplanation()
{
    return {
        .learnt = Text::tr(
            "A loop goes through a list of sticks, and the order of the list decides how fast a pull "
            "arrives."),
    };
}

Explanation verletExplanation()
{
    return {
        .learnt =
            Text::tr("A velocity that is the way a point came holds whatever moved the point, sticks and "
                     "walls, too."),
        .terms =
            {
                {Text::tr("Verlet integration"), Text::tr("Verlet integration|Verlet"),
                 Text::tr("A method that keeps the last two places of a point in place of its velocity. The "
                          "way from one to the other is the velocity.")},
                {Text::tr("Iteration"), Text::tr("iterations|iteration"),
                 Text::tr("One pass through the list of sticks. More of them in a frame make what the sticks "
                          "hold stiffer.")},
                {Text::tr("Friction"), Text::tr("friction"),
                 Text::tr(
                     "What holds back a thing that slides along a wall. The harder it is pressed against "
                     "the wall, the more.")},
            },
        .whys =
            {
                {Text::tr("Why is a place minus a place a velocity?"),
                 Text::tr(
                     "A velocity is how far a thing comes in a frame. So it is already there, in the last "
                     "two "
                     "places:\n\n"
                     "`v = x − before`\n\n"
                     "The next place is this one, plus the velocity, plus what gravity adds:\n\n"
                     "`next = x + (x − before) + g`\n\n"
                     "And if a stick has moved x meanwhile, x − before is another number: the velocity knows "
                     "of it without being told.")},
            },
    };
}

Explanation ragdollExplanation()
{
    return {
        .learnt =
            Text::tr("Points, sticks and joint limits are enough for a whole figure; more passes leave less "
                     "error."),
        .terms =
            {
                {Text::tr("Joint limit"), Text::tr("joint limits|joint limit"),
                 Text::tr(
                     "A constraint on an angle: it acts only when a joint is bent farther than it may be.")},
            },
    };
}

}
