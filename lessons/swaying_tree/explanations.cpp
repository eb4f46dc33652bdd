#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace swaying_tree {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(SwayingTree)
};

Teaching trunk()
{
    return {
        "trunk",
        Text::tr("A branch is an origin, an angle and a length; cos and sin tell where it ends."),
        {
            Text::tr(
                "Choose **published** beside **Formula**, and press **→**. Then rest the pointer on `end` "
                "in the code."),
            Text::tr("Type 200 into the field beside **Trunk length**."),
        },
        {{Text::tr("Sine and cosine"), Text::tr("cos and sin|sine"),
          Text::tr("The two numbers of a way of 1 px at an angle: cos is how far to the right, sin how far "
                   "down.")}},
        {{Text::tr("Why divide by 57.2958?"),
          Text::tr("A full turn is 360°. Counted by the arc of a circle of radius 1 it is 2π:\n\n"
                   "`360° = 2π rad = 6.2832 rad`\n\n"
                   "So one radian is\n\n"
                   "`360° / 6.2832 = 57.2958°`\n\n"
                   "cos and sin count in radians. An angle in degrees is divided by that number first:\n\n"
                   "`−90° / 57.2958 = −1.5708 rad`")}}};
}

Teaching branches()
{
    return {
        "branches",
        Text::tr("A rule that uses itself grows a whole tree, and a smallest size ends it."),
        {
            Text::tr("Type 90 into the field beside **Spread**."),
            Text::tr("Type 0.7 into the field beside **Slope**. The number of branches stands above the "
                     "parameters."),
            Text::tr("The children of the trunk are 0.8 (or 0.7) as large, and their children 0.64 (or "
                     "0.49). Type "
                     "0.65 beside **Smallest branch**."),
        },
        {{Text::tr("Rule that uses itself"), Text::tr("rule that uses itself"),
          Text::tr("A rule whose last part is: and now do the same again, with something smaller. Its name "
                   "is recursion. It needs an end.")}},
        {}};
}

Teaching randomness()
{
    return {
        "randomness",
        Text::tr("Chance that is worked out from a seed makes a tree look real and grow the same each "
                 "time."),
        {
            Text::tr("Type 0 into the field beside **Jitter**."),
            Text::tr("Type 60 into the field beside **Jitter**."),
            Text::tr("Above the parameters, press **Presets** and choose a picture. Or type another number "
                     "beside **Spread**."),
        },
        {{Text::tr("Jitter"), Text::tr("jitter"),
          Text::tr("How far chance may turn a thing from where it should point.")}},
        {}};
}

Teaching towardsPointer()
{
    return {
        "towards_pointer",
        Text::tr("Every branch turns from the trunk outwards, as a child begins where its parent ends."),
        {
            Text::tr("Press **Space**. Put the pointer into the picture beside the tree, hold the mouse "
                     "button down, and keep still."),
            Text::tr("Choose **published** beside **Formula**. Then hold the mouse button down beside the "
                     "tree and count."),
            Text::tr("Press **Space**. Hold the mouse button down near the ground, right of the trunk, for "
                     "a moment, and let go."),
        },
        {},
        {}};
}

Teaching wind()
{
    return {
        "wind",
        Text::tr("To turn by a part of what is missing is fast at first and then slower, and it has to go "
                 "the short way round."),
        {
            Text::tr("Press **Space**. Hold the mouse button down low in the left or right corner for two "
                     "seconds."),
            Text::tr("Press **Home**. Type 2 beside **Ease**, press **Space**, and hold the mouse button "
                     "down for a second. "
                     "Then type 30 beside **Ease**, and hold it again."),
            Text::tr(
                "Press **Home**, then **Space**, and hold the mouse button down close to the tree for "
                "two seconds. Stop, drag the timeline back by twenty frames, choose **published** beside "
                "**Formula**, and play on."),
        },
        {{Text::tr("Ease"), Text::tr("ease"),
          Text::tr("Each frame a branch turns by the missing angle divided by this number. So it starts "
                   "fast and arrives gently.")}},
        {{Text::tr("Why 180° and not 360°?"),
          Text::tr("Two angles a turn apart are the same direction. From −170° to 170° one can go\n\n"
                   "`170 − (−170) = 340°`\n\n"
                   "or the other way round:\n\n"
                   "`340 − 360 = −20°`\n\n"
                   "The short way is never more than half a turn. So if what is missing is more than 180°, "
                   "take a whole turn off it; if it is less than −180°, add one. Were the test at 360°, "
                   "every way between 180° and 360° would be taken the long way.")}}};
}

Teaching rest()
{
    return {
        "rest",
        Text::tr("A branch that remembers the angle at which it grew comes back to it, and without a "
                 "velocity it never swings past."),
        {
            Text::tr("Press **Space**. Hold the mouse button down at the foot of the trunk for two seconds, "
                     "let go, and wait."),
            Text::tr("Type 30 into the field beside **Ease**. Hold the mouse button down at the foot of the "
                     "trunk for seven seconds, let go, and wait."),
            Text::tr("Press **Space** and hold the mouse button down beside the tree. With the button down, "
                     "press **Space** to stop, and then **Shift+→** until the tree has returned."),
        },
        {},
        {}};
}

Teaching distance()
{
    return {
        "distance",
        Text::tr("Divided by the distance, the wind is strong near by and weak far away."),
        {
            Text::tr("Press **Space**. Hold the mouse button down right at the end of a twig, and follow the "
                     "twig."),
            Text::tr("Press **Space**, and hold the mouse button down in an upper corner of the picture for "
                     "three seconds."),
            Text::tr(
                "Press **Space** and hold the mouse button down for two seconds. Stop, drag the timeline "
                "back by twenty frames, choose **published** beside **Formula**, and play on."),
        },
        {},
        {}};
}

Teaching thickness()
{
    return {
        "thickness",
        Text::tr("Thick branches resist by their scale twice, so twigs turn first."),
        {
            Text::tr("Press **Space**, and hold the mouse button down left of the crown for a second."),
            Text::tr("Type 20 into the field beside **Wind**. Press **Space**, and hold the mouse button "
                     "down close beside the trunk for two seconds."),
            Text::tr(
                "Press **Home**, then **Space**, and hold the mouse button down on a twig in the crown for "
                "two seconds. Stop, drag the timeline back by twenty frames, choose **published** beside "
                "**Formula**, and play on."),
        },
        {},
        {}};
}

Teaching turbulence()
{
    return {
        "turbulence",
        Text::tr("The same chance for all branches makes twigs tremble, while the trunk hardly feels it."),
        {
            Text::tr("Press **Space**, and hold the mouse button down left of the crown for three "
                     "seconds."),
            Text::tr("Hold the mouse button down for two seconds while it plays, and stop. Drag the "
                     "timeline back to soon after the wind began, type 0 beside **Turbulence**, and play "
                     "on."),
            Text::tr("Above the parameters, press **Presets** and choose a picture. Press **Space** and hold "
                     "the mouse button down close to the tree."),
        },
        {{Text::tr("Turbulence"), Text::tr("turbulence"),
          Text::tr("How far chance turns the wind in each frame, the same for all.")}},
        {}};
}

Teaching realSway()
{
    return {
        "real_sway",
        Text::tr("With a spin and a spring in each joint, a gust in the twigs moves the trunk, and the tree "
                 "swings past its rest."),
        {
            Text::tr("Press **Space**. Hold the mouse button down left of the tree for two seconds, let go, "
                     "and wait."),
            Text::tr("Press **Space**, and press the mouse button at the left edge. Half a second later, "
                     "with the button down, press **Space** again."),
            Text::tr("Type 1 into the field beside **Damping**. Press **Space**, hold the mouse button down "
                     "for a second, let go, and wait ten seconds."),
            Text::tr("Above the parameters, press **Presets** and choose a picture. Press **Space** and hold "
                     "the mouse button down left of the tree for two seconds."),
        },
        {
            {Text::tr("Torque"), Text::tr("torque"),
             Text::tr("What turns a thing, as a pull moves it. A joint that is twisted twice as far turns "
                      "back twice as hard.")},
            {Text::tr("Spin"), Text::tr("spin"),
             Text::tr("How far a thing turns in a frame, in degrees. What velocity is to a place, spin is "
                      "to an angle.")},
            {Text::tr("Inertia"), Text::tr("inertia"),
             Text::tr("How hard it is to set a thing turning, or to stop it. More mass farther out means "
                      "more of it.")},
        },
        {}};
}

}

std::vector<Teaching> teaching()
{
    return {trunk(), branches(), randomness(), towardsPointer(), wind(),
            rest(),  distance(), thickness(),  turbulence(),     realSway()};
}

}
