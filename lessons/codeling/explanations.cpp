#include "explanations.h"
#include "lessons/codeling/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace codeling {

Explanation motorExplanation()
{
    return {
        .learnt = Text::tr("A spring from the head to a target is a motor: fast at first, slower by itself."),
        .terms =
            {
                {Text::tr("Lead"), Text::tr("the lead"),
                 Text::tr("The head of the creature. The motor pulls it, and all else follows.")},
                {Text::tr("Time step"), Text::tr("dt"),
                 Text::tr("How much of its own time passes for a creature in a frame. The smaller it is, the "
                          "slower everything goes.")},
            },
        .whys =
            {
                {Text::tr("Why dt × dt?"),
                 Text::tr(
                     "A pull changes the velocity, and the velocity changes the place. In a quarter of the "
                     "time a pull adds a quarter as much to the velocity:\n\n"
                     "`v = v + dt × pull`\n\n"
                     "And that velocity carries the point for a quarter of the time:\n\n"
                     "`x = x + dt × v`\n\n"
                     "Both together:\n\n"
                     "`0.25 × 0.25 = 0.0625`\n\n"
                     "So the place changes by a sixteenth, and 0.9 does as much as 0.9 / 16, which is "
                     "0.056.")},
            },
    };
}

Explanation orientationExplanation()
{
    return {
        .learnt = Text::tr("A tail on a one-sided stick gives a direction: from tail to lead."),
        .terms =
            {
                {Text::tr("One-sided"), Text::tr("one-sided"),
                 Text::tr(
                     "A stick of which one end takes the whole error. The other end feels nothing of it, so "
                     "it leads.")},
            },
    };
}

Explanation anticipationExplanation()
{
    return {
        .learnt = Text::tr("A shift away from the target, in the frame of the click, looks like winding up."),
        .terms =
            {
                {Text::tr("Anticipation"), Text::tr("anticipation"),
                 Text::tr("A small move the other way before a big one. It tells the eye what comes.")},
            },
    };
}

Explanation squashStretchExplanation()
{
    return {
        .learnt = Text::tr("A soft stick takes a part of its error each frame, so the body gives way."),
        .terms =
            {
                {Text::tr("Soft constraint"), Text::tr("is soft|soft stick|soft and one-sided"),
                 Text::tr(
                     "A constraint that takes only a part of its error each frame. It gives way, and comes "
                     "back little by little.")},
                {Text::tr("Squash and stretch"),
                 {},
                 Text::tr(
                     "Animators’ words for a body that gets shorter and wider, or longer and thinner, as it "
                     "moves. It makes a body look soft and alive.")},
            },
    };
}

Explanation volumeExplanation()
{
    return {
        .learnt = Text::tr("If the area must stay, the width follows from the length."),
        .whys =
            {
                {Text::tr("Why 2 × area / spine?"),
                 Text::tr(
                     "The spine cuts the shape into two triangles. Each has the spine as its base and half "
                     "of the width as its height, and the area of a triangle is base × height / 2:\n\n"
                     "`2 × spine × (width / 2) / 2`\n\n"
                     "That is\n\n"
                     "`area = spine × width / 2`\n\n"
                     "Now ask the other way round. Which width keeps the area?\n\n"
                     "`width = 2 × area / spine`")},
            },
    };
}

Explanation tentaclesExplanation()
{
    return {
        .learnt = Text::tr(
            "A chain of one-sided sticks is right after one pass, because no link disturbs an earlier "
            "one."),
    };
}

}
