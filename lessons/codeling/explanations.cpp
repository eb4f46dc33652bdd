#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace codeling {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Codeling)
};

Teaching motor()
{
    return {
        "motor",
        Text::tr("A spring from the head to a target is a motor: fast at first, slower by itself."),
        {
            Text::tr("Press **Space**, and click the background near the edge of the picture. Then "
                     "wait."),
            Text::tr("Press **Space**. Take the head (the lead), swing it quickly, let go on the way, and "
                     "wait."),
            Text::tr("Type 1 into the field beside **Keep**. Press **Space**, click the background, and "
                     "wait four seconds."),
        },
        {{Text::tr("Lead"), Text::tr("the lead"),
          Text::tr("The head of the creature. The motor pulls it, and all else follows.")},
         {Text::tr("Time step"), Text::tr("dt"),
          Text::tr("How much of its own time passes for a creature in a frame. The smaller it is, the "
                   "slower everything goes.")}},
        {{Text::tr("Why dt × dt?"),
          Text::tr("A pull changes the velocity, and the velocity changes the place. In a quarter of the "
                   "time a pull adds a quarter as much to the velocity:\n\n"
                   "`v = v + dt × pull`\n\n"
                   "And that velocity carries the point for a quarter of the time:\n\n"
                   "`x = x + dt × v`\n\n"
                   "Both together:\n\n"
                   "`0.25 × 0.25 = 0.0625`\n\n"
                   "So the place changes by a sixteenth, and 0.9 does as much as 0.9 / 16, which is "
                   "0.056.")}}};
}

Teaching orientation()
{
    return {
        "orientation",
        Text::tr("A tail on a one-sided stick gives a direction: from tail to lead."),
        {
            Text::tr("Press **Space**. Click far up in the picture, and when it is under way, click far to "
                     "the left."),
            Text::tr("Press **Space**. Take the tail, carry it across the picture, let go, and wait."),
            Text::tr("Stop. Click the background far off, on the side away from its tail, and go on with "
                     "**→** until it is "
                     "fast. Then press **Shift+→** until the strip under the timeline marks the move."),
        },
        {{Text::tr("One-sided"), Text::tr("one-sided"),
          Text::tr("A stick of which one end takes the whole error. The other end feels nothing of it, so "
                   "it leads.")}},
        {}};
}

Teaching anticipation()
{
    return {"anticipation",
            Text::tr("A shift away from the target, in the frame of the click, looks like winding up."),
            {
                Text::tr("Stop. Click the background far from the creature, and press **Shift+→** until the "
                         "strip under the timeline marks the anticipation."),
                Text::tr("Type 0.6 into the field beside **Anticipation**. Press **Space** and click far "
                         "away."),
                Text::tr("Play, click the background, and stop. Drag the timeline back to before the click, "
                         "type another **Anticipation**, and play on for half a second."),
            },
            {{Text::tr("Anticipation"), Text::tr("anticipation"),
              Text::tr("A small move the other way before a big one. It tells the eye what comes.")}},
            {}};
}

Teaching squashStretch()
{
    return {
        "squash_stretch",
        Text::tr("A soft stick takes a part of its error each frame, so the body gives way."),
        {
            Text::tr("Press **Space**, and click the background in the corner that is farthest away."),
            Text::tr("Press **Space**. It looks to the right at the start: click the background far to the "
                     "right, at the same height."),
            Text::tr("Play, click the background, and stop. Drag the timeline back to the left, type 1 "
                     "beside **Soft**, and play on for a second."),
        },
        {{Text::tr("Soft constraint"), Text::tr("is soft|soft stick|soft and one-sided"),
          Text::tr("A constraint that takes only a part of its error each frame. It gives way, and comes "
                   "back little by little.")},
         {Text::tr("Squash and stretch"),
          {},
          Text::tr("Animators’ words for a body that gets shorter and wider, or longer and thinner, as it "
                   "moves. It makes a body look soft and alive.")}},
        {}};
}

Teaching volume()
{
    return {
        "volume",
        Text::tr("If the area must stay, the width follows from the length."),
        {
            Text::tr("Press **Space**. It looks to the right at the start: click the background far to the "
                     "right, at the same height."),
            Text::tr("Press **Space**, and click the background in the corner that is farthest away."),
            Text::tr("Press **Space**. Take one of the two points at its sides, pull it away from the body, "
                     "and do not let go."),
        },
        {},
        {{Text::tr("Why 2 × area / spine?"),
          Text::tr("The spine cuts the shape into two triangles. Each has the spine as its base and half "
                   "of the width as its height, and the area of a triangle is base × height / 2:\n\n"
                   "`2 × spine × (width / 2) / 2`\n\n"
                   "That is\n\n"
                   "`area = spine × width / 2`\n\n"
                   "Now ask the other way round. Which width keeps the area?\n\n"
                   "`width = 2 × area / spine`")}}};
}

Teaching tentacles()
{
    return {
        "tentacles",
        Text::tr("A chain of one-sided sticks is right after one pass, because no link disturbs an earlier "
                 "one."),
        {
            Text::tr("Type 8 into the field beside **Tentacles**. Press **Space**, click the background, "
                     "and wait."),
            Text::tr("Type 0.98 into the field beside **Water**. Press **Space**, and click one corner and "
                     "the opposite one in turn, twice a second."),
            Text::tr("Play, click the background, and stop. Drag the timeline back to the left, type "
                     "another **Water**, and play on for a second."),
        },
        {},
        {}};
}

}

std::vector<Teaching> teaching()
{
    return {motor(), orientation(), anticipation(), squashStretch(), volume(), tentacles()};
}

}
