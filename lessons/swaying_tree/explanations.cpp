#include "explanations.h"
#include "lessons/swaying_tree/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace swaying_tree {

Explanation trunkExplanation()
{
    return {
        .learnt = Text::tr("A branch is an origin, an angle and a length; cos and sin tell where it ends."),
        .terms =
            {
                {Text::tr("Sine and cosine"), Text::tr("cos and sin|sine"),
                 Text::tr(
                     "The two numbers of a way of 1 px at an angle: cos is how far to the right, sin how far "
                     "down.")},
            },
        .whys =
            {
                {Text::tr("Why divide by 57.2958?"),
                 Text::tr(
                     "A full turn is 360°. Counted by the arc of a circle of radius 1 it is 2π:\n\n"
                     "`360° = 2π rad = 6.2832 rad`\n\n"
                     "So one radian is\n\n"
                     "`360° / 6.2832 = 57.2958°`\n\n"
                     "cos and sin count in radians. An angle in degrees is divided by that number first:\n\n"
                     "`−90° / 57.2958 = −1.5708 rad`")},
            },
    };
}

Explanation branchesExplanation()
{
    return {
        .learnt = Text::tr("A rule that uses itself grows a whole tree, and a smallest size ends it."),
        .terms =
            {
                {Text::tr("Rule that uses itself"), Text::tr("rule that uses itself"),
                 Text::tr(
                     "A rule whose last part is: and now do the same again, with something smaller. Its name "
                     "is recursion. It needs an end.")},
            },
    };
}

Explanation randomnessExplanation()
{
    return {
        .learnt =
            Text::tr("Chance that is worked out from a seed makes a tree look real and grow the same each "
                     "time."),
        .terms =
            {
                {Text::tr("Jitter"), Text::tr("jitter"),
                 Text::tr("How far chance may turn a thing from where it should point.")},
            },
    };
}

Explanation towardsPointerExplanation()
{
    return {
        .learnt =
            Text::tr("Every branch turns from the trunk outwards, as a child begins where its parent ends."),
    };
}

Explanation windExplanation()
{
    return {
        .learnt = Text::tr(
            "To turn by a part of what is missing is fast at first and then slower, and it has to go "
            "the short way round."),
        .terms =
            {
                {Text::tr("Ease"), Text::tr("ease"),
                 Text::tr(
                     "Each frame a branch turns by the missing angle divided by this number. So it starts "
                     "fast and arrives gently.")},
            },
        .whys =
            {
                {Text::tr("Why 180° and not 360°?"),
                 Text::tr(
                     "Two angles a turn apart are the same direction. From −170° to 170° one can go\n\n"
                     "`170 − (−170) = 340°`\n\n"
                     "or the other way round:\n\n"
                     "`340 − 360 = −20°`\n\n"
                     "The short way is never more than half a turn. So if what is missing is more than 180°, "
                     "take a whole turn off it; if it is less than −180°, add one. Were the test at 360°, "
                     "every way between 180° and 360° would be taken the long way.")},
            },
    };
}

Explanation restExplanation()
{
    return {
        .learnt =
            Text::tr("A branch that remembers the angle at which it grew comes back to it, and without a "
                     "velocity it never swings past."),
    };
}

Explanation distanceExplanation()
{
    return {
        .learnt = Text::tr("Divided by the distance, the wind is strong near by and weak far away."),
    };
}

Explanation thicknessExplanation()
{
    return {
        .learnt = Text::tr("Thick branches resist by their scale twice, so twigs turn first."),
    };
}

Explanation turbulenceExplanation()
{
    return {
        .learnt = Text::tr(
            "The same chance for all branches makes twigs tremble, while the trunk hardly feels it."),
        .terms =
            {
                {Text::tr("Turbulence"), Text::tr("turbulence"),
                 Text::tr("How far chance turns the wind in each frame, the same for all.")},
            },
    };
}

Explanation realSwayExplanation()
{
    return {
        .learnt = Text::tr(
            "With a spin and a spring in each joint, a gust in the twigs moves the trunk, and the tree "
            "swings past its rest."),
        .terms =
            {
                {Text::tr("Torque"), Text::tr("torque"),
                 Text::tr(
                     "What turns a thing, as a pull moves it. A joint that is twisted twice as far turns "
                     "back twice as hard.")},
                {Text::tr("Spin"), Text::tr("spin"),
                 Text::tr(
                     "How far a thing turns in a frame, in degrees. What velocity is to a place, spin is "
                     "to an angle.")},
                {Text::tr("Inertia"), Text::tr("inertia"),
                 Text::tr("How hard it is to set a thing turning, or to stop it. More mass farther out means "
                          "more of it.")},
            },
    };
}

}
