#include "explanations.h"
#include "lessons/multi_foot/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace multi_foot {

Explanation twoFeetExplanation()
{
    return {
        .learnt = Text::tr("Several pulls on one body add up, one after the other."),
    };
}

Explanation anyNumberExplanation()
{
    return {
        .learnt = Text::tr("A loop adds the springs, so the same code does for any number of feet."),
        .terms =
            {
                {Text::tr("Loop"), Text::tr("loop|one loop"),
                 Text::tr("Lines of code that are done again and again, once for each thing in a list.")},
                {Text::tr("Parameter"), Text::tr("parameter|parameters"),
                 Text::tr("A number of the scene that you can change, at the lower right.")},
            },
    };
}

Explanation grownFeetExplanation()
{
    return {
        .learnt =
            Text::tr("Many soft springs on one body hold it like one stiff spring, and a whole frame can be "
                     "too long a step for that."),
        .terms =
            {
                {Text::tr("Seed"), Text::tr("seed"),
                 Text::tr(
                     "A whole number from which all chance of a run is worked out. The same seed gives the "
                     "same run.")},
            },
        .whys =
            {
                {Text::tr("Why are many soft springs like a stiff one?"),
                 Text::tr(
                     "Move the body by 1 px. A spring that points that way pulls it back by k. With n "
                     "springs like it, it is\n\n"
                     "`n × k`\n\n"
                     "at once. Springs that point to the side pull less, so on the average about half of "
                     "them count.\n\n"
                     "If that is so much that the body comes back **past** its place, and by more than it "
                     "was away, then the next pull is stronger still. From then on each swing is wider "
                     "than the last.")},
            },
    };
}

}
