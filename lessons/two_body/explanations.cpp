#include "explanations.h"
#include "lessons/two_body/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace two_body {

Explanation mutualExplanation()
{
    return {
        .learnt = Text::tr(
            "Who moves first matters: if one sees the other where it already is, momentum comes from "
            "nowhere."),
        .terms =
            {
                {Text::tr("Momentum"), Text::tr("momentum"),
                 Text::tr("All velocities added up (times the mass, where masses differ). What only pulls "
                          "each other cannot change it.")},
                {Text::tr("Method"), Text::tr("method|methods"),
                 Text::tr(
                     "The recipe that computes the next frame from this one: what is asked for when, and "
                     "what moves when. You choose it above the picture.")},
                {Text::tr("Semi-implicit Euler"), Text::tr("Semi-implicit Euler"),
                 Text::tr("A method: first all velocities get their pulls, and then everything moves by its "
                          "new velocity.")},
            },
        .whys =
            {
                {Text::tr("Why does a spring pull both ends?"),
                 Text::tr(
                     "Hold a rubber band between two hands: each hand feels it, and just as hard. What "
                     "pulls is pulled back:\n\n"
                     "`pull on body = − pull on foot`\n\n"
                     "So whatever the foot gains, the body loses, and the sum stays:\n\n"
                     "`v_foot + v_body = the same`\n\n"
                     "That holds only if both pulls are taken **at the same moment**. If the foot moves "
                     "first, the body feels another distance than the foot felt. Then the two pulls do not "
                     "cancel, and what is left over pushes the pair along.")},
            },
    };
}

Explanation legLineExplanation()
{
    return {
        .learnt = Text::tr("A leg is only drawn: it shows how long the spring is, and changes nothing."),
    };
}

}
