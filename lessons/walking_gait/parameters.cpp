#include "parameters.h"

#include "lessons/api/parameters.h"

#include <QCoreApplication>

using namespace lessons;

namespace walking_gait {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(WalkingGait)
};

Parameter inPixels(const char *id, const QString &name, const QString &help, double preset, double sliderMin,
                   double sliderMax)
{
    return {id, name, {}, Text::tr("px"), help, preset, -1e6, 1e6, sliderMin, sliderMax, 0, {}};
}

Parameter count(const char *id, const QString &name, const QString &help, double preset, double most)
{
    return {id, name, {}, {}, help, preset, 2.0, most, 2.0, most, 0, {}, true};
}

}

Parameter leg()
{
    return inPixels("leg", Text::tr("Leg"), Text::tr("How far a foot belongs from the middle of its places."),
                    50.0, 0.0, 150.0);
}

Parameter drop()
{
    return inPixels("drop", Text::tr("Drop"), Text::tr("How far below the body the feet belong."), 50.0,
                    -100.0, 150.0);
}

Parameter curve()
{
    return inPixels("curve", Text::tr("Curve"),
                    Text::tr("How high above its foot the point lies that bends a leg. Only drawn."), 50.0,
                    -50.0, 150.0);
}

Parameter speed()
{
    return {"speed",
            Text::tr("Speed"),
            {},
            Text::tr("rad/frame"),
            Text::tr("How far the gait clock turns each frame. Below 0 it turns the other way."),
            0.05,
            -10.0,
            10.0,
            -0.3,
            0.5,
            3,
            {}};
}

Parameter footBounce()
{
    Parameter parameter = bounce(0.0);
    parameter.help = Text::tr("The share of its speed that a foot keeps, turned round, on the ground.");
    return parameter;
}

Parameter traction()
{
    Parameter parameter =
        choice("traction", Text::tr("Traction"),
               Text::tr("Whether the ground stops a foot sideways, too. Without it is ice."),
               {QStringLiteral("full"), QStringLiteral("none")});
    parameter.choiceTitles = {Text::tr("full"), Text::tr("none")};
    return parameter;
}

Parameter legCount()
{
    return count("feet", Text::tr("Feet"), Text::tr("How many feet the body has."), 5.0, 12.0);
}

Parameter spread()
{
    return {"spread",
            Text::tr("Spread"),
            {},
            Text::tr("°"),
            Text::tr("Over how much of a turn the feet are spread. At 0 all step together."),
            360.0,
            -1e6,
            1e6,
            0.0,
            720.0,
            0,
            {}};
}

Parameter top()
{
    return {"top",
            Text::tr("Top speed"),
            {},
            Text::tr("rad/frame"),
            Text::tr("The fastest that keys and pointer make the gait clock."),
            0.15,
            0.0,
            10.0,
            0.0,
            0.3,
            3,
            {}};
}

Parameter change()
{
    return {"change",
            Text::tr("Change"),
            {},
            Text::tr("rad/frame²"),
            Text::tr("How much speed an arrow key adds or takes away, each frame that it is down."),
            0.0025,
            0.0,
            10.0,
            0.0,
            0.02,
            4,
            {}};
}

Parameter atWall()
{
    Parameter parameter = choice("at_wall", Text::tr("At a wall"),
                                 Text::tr("Whether it turns round where it bumps into a wall, or walks on."),
                                 {QStringLiteral("turn"), QStringLiteral("keep_on")});
    parameter.choiceTitles = {Text::tr("turn"), Text::tr("walk on")};
    return parameter;
}

Parameter creatures()
{
    return count("creatures", Text::tr("Creatures"), Text::tr("How many creatures there are."), 2.0, 5.0);
}

Parameter push()
{
    return {"push",
            Text::tr("Push"),
            "k",
            Text::tr("1/frame²"),
            Text::tr("How hard two bodies push: this share of the missing distance, each frame."),
            0.1,
            0.0,
            1e9,
            0.0,
            0.5,
            2,
            {}};
}

Parameter distance()
{
    return inPixels("distance", Text::tr("Distance"),
                    Text::tr("Two bodies closer than this push each other."), 60.0, 0.0, 150.0);
}

Parameter feltBy()
{
    Parameter parameter =
        choice("felt_by", Text::tr("Felt by"),
               Text::tr("Whether both bodies feel a push, or only the one that comes first."),
               {QStringLiteral("both"), QStringLiteral("one")});
    parameter.choiceTitles = {Text::tr("both"), Text::tr("one")};
    return parameter;
}

}
