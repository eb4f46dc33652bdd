#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace multi_foot {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(MultiFoot)
};

Teaching twoFeet()
{
    return {"two_feet",
            Text::tr("Several pulls on one body add up, one after the other."),
            {
                Text::tr(
                    "Press **Space**. Take one of the small discs, pull it to the upper edge of the picture, "
                    "let go, and wait."),
                Text::tr("Press **Space**, take the large disc, and carry it from one side of the picture to "
                         "the other."),
                Text::tr("Press **Home**. Type 0.9 into the field beside **Damping**, press **Space**, and "
                         "touch nothing."),
            },
            {},
            {}};
}

Teaching anyNumber()
{
    return {
        "any_number",
        Text::tr("A loop adds the springs, so the same code does for any number of feet."),
        {
            Text::tr(
                "Press **Space**, pull one of the small discs to the upper edge of the picture, let go, and "
                "wait."),
            Text::tr("Press **Home**. Type 12 into the field beside **Feet**, press **Space**, and wait "
                     "seven seconds."),
            Text::tr("Play some seconds, drag the timeline back to the left, change **Damping**, and play "
                     "on for a second."),
        },
        {
            {Text::tr("Loop"), Text::tr("loop|one loop"),
             Text::tr("Lines of code that are done again and again, once for each thing in a list.")},
            {Text::tr("Parameter"), Text::tr("parameter|parameters"),
             Text::tr("A number of the scene that you can change, at the lower right.")},
        },
        {}};
}

Teaching grownFeet()
{
    return {
        "grown_feet",
        Text::tr("Many soft springs on one body hold it like one stiff spring, and a whole frame can be "
                 "too long a step for that."),
        {
            Text::tr("Type 16 into the field beside **Feet**. Above the picture, choose **Semi-implicit "
                     "Euler** as method. Press **Space** and wait."),
            Text::tr("Type 60 into the field beside **Feet**, and press **Space**. It takes some seconds."),
            Text::tr("Leave 60 in the field beside **Feet**, press **Home** to go to frame 0, choose **1/2 "
                     "frame** as step above the picture, and press **Space**."),
        },
        {{Text::tr("Seed"), Text::tr("seed"),
          Text::tr("A whole number from which all chance of a run is worked out. The same seed gives the "
                   "same run.")}},
        {{Text::tr("Why are many soft springs like a stiff one?"),
          Text::tr("Move the body by 1 px. A spring that points that way pulls it back by k. With n "
                   "springs like it, it is\n\n"
                   "`n × k`\n\n"
                   "at once. Springs that point to the side pull less, so on the average about half of "
                   "them count.\n\n"
                   "If that is so much that the body comes back **past** its place, and by more than it "
                   "was away, then the next pull is stronger still. From then on each swing is wider "
                   "than the last.")}}};
}

}

std::vector<Teaching> teaching()
{
    return {twoFeet(), anyNumber(), grownFeet()};
}

}
