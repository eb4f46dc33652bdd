#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace gravity_walls {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(GravityWalls)
};

Teaching walls()
{
    return {
        "walls",
        Text::tr("A wall puts back what went too far, and turns its velocity round."),
        {
            Text::tr("Press **Space**, take the large disc, swing it quickly to the left, and let go on "
                     "the way."),
            Text::tr("Throw the creature at a wall and stop just before it is there. Then press "
                     "**Shift+→** again and again: after a move, look whether an edge is past the wall."),
            Text::tr("Type 0 into the field beside **Bounce**, press **Space**, and throw the creature at "
                     "the left or the right wall."),
            Text::tr("Press **Space**, take the large disc, swing it quickly up past the upper edge, and "
                     "let go on the way."),
        },
        {{Text::tr("Bounce"), Text::tr("bounce"),
          Text::tr("The share of its velocity that a thing keeps when a wall turns it round. At 1 it comes "
                   "back as fast as it came, at 0 it stays at the wall.")}},
        {}};
}

Teaching gravity()
{
    return {
        "gravity",
        Text::tr("Gravity is one more pull, the same for everything, and it comes before damping."),
        {
            Text::tr("Press **Space**, take the large disc, lift it to the upper edge, and hold it there "
                     "until the feet have stopped swinging."),
            Text::tr("Type 0.6 into the field beside **Damping**. Then lift the large disc and hold it, as "
                     "before."),
            Text::tr("Stop, and press **Shift+→** until the strip under the timeline marks gravity."),
            Text::tr("Type 240 beside **Left wall** and 300 beside **Right wall**. Press **Space**, lift the "
                     "large disc until its feet hang under it, let it down slowly until they stand, and let "
                     "go."),
        },
        {{Text::tr("Gravity"), Text::tr("gravity"),
          Text::tr("A pull straight down that is the same for everything: each frame it adds as much to "
                   "the velocity, however far down a thing is.")}},
        {{Text::tr("Why is a fall a parabola?"),
          Text::tr("Gravity adds the same to the velocity in each frame, so after t frames it is\n\n"
                   "`v = g × t`\n\n"
                   "The ways add up. The first is short and the last is the longest; the middle one, half "
                   "of g × t, stands for all:\n\n"
                   "`way = g × t² / 2`\n\n"
                   "Twice as long, four times as deep. Sideways nothing pulls, so a thrown thing goes "
                   "equally far each frame. Evenly to the side and ever faster down: that curve is a "
                   "parabola.\n\n"
                   "(In steps of a frame, without damping, the sum is g × t × (t + 1) / 2: a little more. "
                   "The lesson Accuracy is about that.)")}}};
}

}

std::vector<Teaching> teaching()
{
    return {walls(), gravity()};
}

}
