#include "explanations.h"
#include "lessons/single_spring/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace single_spring {

Explanation dragExplanation()
{
    return {
        .learnt =
            Text::tr("A place and a velocity are two numbers each, and damping is the share of the velocity "
                     "that is kept in every frame."),
        .terms =
            {
                {Text::tr("Frame"), Text::tr("frame|frames"),
                 Text::tr("One picture of the run, and the time from it to the next. 30 of them are shown in "
                          "a second, unless you choose another speed.")},
                {Text::tr("Velocity"), Text::tr("velocity|velocities"),
                 Text::tr("How far something goes in a frame, and which way: one number for x and one for y, "
                          "in pixels per frame.")},
                {Text::tr("Damping"), Text::tr("damping"),
                 Text::tr("The share of its velocity that a thing keeps each frame. At 0.9 a tenth of it is "
                          "gone after one frame. At 1 nothing is.")},
            },
        .whys =
            {
                {Text::tr("Why does a throw of 10 px glide 90 px?"),
                 Text::tr(
                     "Each frame keeps 0.9 of the velocity, so the ways get shorter:\n\n"
                     "`9 + 8.1 + 7.29 + …`\n\n"
                     "Every number is 0.9 times the one before. Such a sum never ends, and yet it stays "
                     "below a limit:\n\n"
                     "`10 × 0.9 / (1 − 0.9) = 90`\n\n"
                     "Damping is a share **per frame**. Where a frame is computed in two halves, each half "
                     "keeps the root of it, so that both together keep 0.9:\n\n"
                     "`√0.9 × √0.9 = 0.9`\n\n"
                     "Seen the other way, damping is a **drag**: a push against the motion, and the faster "
                     "a thing is, the stronger the push.")},
            },
    };
}

Explanation fixedCentreExplanation()
{
    return {
        .learnt =
            Text::tr("A spring pulls with k times the distance, and what it pulls swings past the middle."),
        .terms =
            {
                {Text::tr("Spring"), Text::tr("spring|springs"),
                 Text::tr("Something that pulls together what is too far apart, and pushes apart what is too "
                          "close. The more is missing, the stronger it pulls.")},
                {Text::tr("Stiffness"), Text::tr("stiffness|stiffer"),
                 Text::tr("How hard a spring pulls for each pixel: the number k. At 0.2 it adds a fifth of "
                          "the missing distance to the velocity, each frame. Physics calls it the spring "
                          "constant, too.")},
                {Text::tr("Hooke’s law"), Text::tr("Hooke’s law"),
                 Text::tr("Twice as far, twice the pull: a spring pulls with k times the distance.")},
                {Text::tr("Phase"), Text::tr("phase|phases"),
                 Text::tr("A part of a frame: first the springs pull, then damping takes its share, then "
                          "everything moves. While the code shows its page **Engine**, **Shift+→** goes from "
                          "one to the next.")},
                {Text::tr("Overshoot"), Text::tr("overshoots|overshoot"),
                 Text::tr("To go past the place where one wants to be. A swinging foot does so at every "
                          "swing.")},
                {Text::tr("Ghost"), Text::tr("ghost"),
                 Text::tr("The run as it was before you changed something in its past. It is drawn as a "
                          "dashed outline, and goes along with the new run.")},
            },
        .whys =
            {
                {Text::tr("Why twice as far, twice the pull?"),
                 Text::tr("Two springs one after the other share a stretch, and each is stretched by half of "
                          "it. So a stretch of one px in one spring pulls as much as two px in both. That is "
                          "what Robert Hooke saw in 1678:\n\n"
                          "`pull = k × distance`\n\n"
                          "Here it is added to the velocity once a frame, in x and in y apart:\n\n"
                          "`vx = vx + k × (cx − x)`\n\n"
                          "Real springs keep to it as long as they are not bent out of shape.")},
            },
    };
}

Explanation movingBodyExplanation()
{
    return {
        .learnt =
            Text::tr("A spring reads the place of its other end anew in each frame, so what hangs on it "
                     "follows."),
    };
}

Explanation offsetExplanation()
{
    return {
        .learnt =
            Text::tr("An offset moves the target of a spring to a side, whatever side the foot comes from."),
        .terms =
            {
                {Text::tr("Target"), Text::tr("target|targets"),
                 Text::tr("The place that a spring pulls to. It need not be the middle of something.")},
            },
    };
}

Explanation radialExplanation()
{
    return {
        .learnt =
            Text::tr("With an angle the target can be 50 px away in any direction: atan2 finds it, cos and "
                     "sin lead back."),
        .terms =
            {
                {Text::tr("Rest length"), Text::tr("rest length|radius"),
                 Text::tr("The length at which a spring does nothing. A longer one pulls its ends together, "
                          "a shorter one pushes them apart. In these lessons it is called radius.")},
                {Text::tr("Radian"), Text::tr("radian|radians"),
                 Text::tr("A way to count angles: the length of the arc, divided by its radius. A full turn "
                          "is 2π, 6.2832 rad; one rad is 57.2958°.")},
                {Text::tr("atan2"), Text::tr("atan2"),
                 Text::tr("Makes an angle of the two numbers of a direction: `atan2(dy, dx)`. For (0, 0) it "
                          "gives 0.")},
            },
        .whys =
            {
                {Text::tr("Why atan2, and not a division?"),
                 Text::tr(
                     "How steep a way is, is a division:\n\n"
                     "`steepness = dy / dx`\n\n"
                     "But it cannot tell a way from its opposite: −2 / −1 is the same as 2 / 1. And straight "
                     "up, dx is 0, and nothing can be divided by that.\n\n"
                     "`atan2(dy, dx)`\n\n"
                     "gets both numbers, so it sees their signs. It knows all four quarters of a turn, from "
                     "−π to π, and straight up and down as well.\n\n"
                     "`atan2(2, 1) = 1.107 rad`\n\n"
                     "`atan2(−2, −1) = −2.034 rad`")},
            },
    };
}

}
