#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace two_body {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(TwoBody)
};

Teaching mutual()
{
    return {
        "mutual",
        Text::tr("Who moves first matters: if one sees the other where it already is, momentum comes from "
                 "nowhere."),
        {
            Text::tr("Stop, and press **Shift+→** until the strip under the timeline marks the move of the "
                     "foot. The move of the body is still to come."),
            Text::tr("Type 0.3 into the field beside **k**, press **Space**, and touch nothing."),
            Text::tr("Type 0.3 beside **k** and 0.85 beside **Damping**. Then press **Space** and wait."),
            Text::tr(
                "Press **Home**. Type 0.3 beside **k** and 0.9 beside **Damping**. Above the picture, choose "
                "**Semi-implicit Euler** as method. Press **Space** and wait four seconds."),
        },
        {
            {Text::tr("Momentum"), Text::tr("momentum"),
             Text::tr("All velocities added up (times the mass, where masses differ). What only pulls "
                      "each other cannot change it.")},
            {Text::tr("Method"), Text::tr("method|methods"),
             Text::tr("The recipe that computes the next frame from this one: what is asked for when, and "
                      "what moves when. You choose it above the picture.")},
            {Text::tr("Semi-implicit Euler"), Text::tr("Semi-implicit Euler"),
             Text::tr("A method: first all velocities get their pulls, and then everything moves by its "
                      "new velocity.")},
        },
        {{Text::tr("Why does a spring pull both ends?"),
          Text::tr("Hold a rubber band between two hands: each hand feels it, and just as hard. What "
                   "pulls is pulled back:\n\n"
                   "`pull on body = − pull on foot`\n\n"
                   "So whatever the foot gains, the body loses, and the sum stays:\n\n"
                   "`v_foot + v_body = the same`\n\n"
                   "That holds only if both pulls are taken **at the same moment**. If the foot moves "
                   "first, the body feels another distance than the foot felt. Then the two pulls do not "
                   "cancel, and what is left over pushes the pair along.")}}};
}

Teaching legLine()
{
    return {
        "leg_line",
        Text::tr("A leg is only drawn: it shows how long the spring is, and changes nothing."),
        {
            Text::tr("Press **Space**, take the foot, and pull it quickly into a corner. Do not let go "
                     "yet."),
            Text::tr("Press **Space**, take the foot, and push it quickly onto the body. Let go at once."),
            Text::tr("Type 100 into the field beside **Radius**, press **Space**, and wait."),
            Text::tr("Play some seconds, drag the timeline back to where both still move, type another "
                     "**k**, and play "
                     "on for a second."),
        },
        {},
        {}};
}

}

std::vector<Teaching> teaching()
{
    return {mutual(), legLine()};
}

}
