#include "explanations.h"
#include "lessons/gravity_walls/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace gravity_walls {

Explanation wallsExplanation()
{
    return {
        .learnt = Text::tr("A wall puts back what went too far, and turns its velocity round."),
        .terms =
            {
                {Text::tr("Bounce"), Text::tr("bounce"),
                 Text::tr(
                     "The share of its velocity that a thing keeps when a wall turns it round. At 1 it comes "
                     "back as fast as it came, at 0 it stays at the wall.")},
            },
    };
}

Explanation gravityExplanation()
{
    return {
        .learnt = Text::tr("Gravity is one more pull, the same for everything, and it comes before damping."),
        .terms =
            {
                {Text::tr("Gravity"), Text::tr("gravity"),
                 Text::tr(
                     "A pull straight down that is the same for everything: each frame it adds as much to "
                     "the velocity, however far down a thing is.")},
            },
        .whys =
            {
                {Text::tr("Why is a fall a parabola?"),
                 Text::tr(
                     "Gravity adds the same to the velocity in each frame, so after t frames it is\n\n"
                     "`v = g × t`\n\n"
                     "The ways add up. The first is short and the last is the longest; the middle one, half "
                     "of g × t, stands for all:\n\n"
                     "`way = g × t² / 2`\n\n"
                     "Twice as long, four times as deep. Sideways nothing pulls, so a thrown thing goes "
                     "equally far each frame. Evenly to the side and ever faster down: that curve is a "
                     "parabola.\n\n"
                     "(In steps of a frame, without damping, the sum is g × t × (t + 1) / 2: a little more. "
                     "The lesson Accuracy is about that.)")},
            },
    };
}

}
