#include "parameters.h"

#include "lessons/api/parameters.h"
#include "lessons/walking_gait/text.h"

#include <QCoreApplication>

using namespace lessons;

namespace walking_gait {

namespace {

/// Completes an integer of 2 or more.
Parameter count(Parameter parameter)
{
    parameter.min = parameter.sliderMin = 2.0;
    parameter.sliderMax = parameter.max;
    parameter.decimals = 0;
    parameter.isInteger = true;
    return parameter;
}

}

Parameter leg()
{
    return inPixels({
        .id = "leg",
        .name = Text::tr("Leg"),
        .help = Text::tr("How far a foot belongs from the middle of its places."),
        .defaultValue = 50.0,
        .sliderMin = 0.0,
        .sliderMax = 150.0,
    });
}

Parameter drop()
{
    return inPixels({
        .id = "drop",
        .name = Text::tr("Drop"),
        .help = Text::tr("How far below the body the feet belong."),
        .defaultValue = 50.0,
        .sliderMin = -100.0,
        .sliderMax = 150.0,
    });
}

Parameter curve()
{
    return inPixels({
        .id = "curve",
        .name = Text::tr("Curve"),
        .help = Text::tr("How high above its foot the point lies that bends a leg. Only drawn."),
        .defaultValue = 50.0,
        .sliderMin = -50.0,
        .sliderMax = 150.0,
    });
}

Parameter speed()
{
    return {
        .id = "speed",
        .name = Text::tr("Speed"),
        .unit = Text::tr("rad/frame"),
        .help = Text::tr("How far the gait clock turns each frame. Below 0 it turns the other way."),
        .defaultValue = 0.05,
        .min = -10.0,
        .max = 10.0,
        .sliderMin = -0.3,
        .sliderMax = 0.5,
        .decimals = 3,
    };
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
    return count({
        .id = "feet",
        .name = Text::tr("Feet"),
        .help = Text::tr("How many feet the body has."),
        .defaultValue = 5.0,
        .max = 12.0,
    });
}

Parameter spread()
{
    return {
        .id = "spread",
        .name = Text::tr("Spread"),
        .unit = Text::tr("°"),
        .help = Text::tr("Over how much of a turn the feet are spread. At 0 all step together."),
        .defaultValue = 360.0,
        .min = -1e6,
        .max = 1e6,
        .sliderMin = 0.0,
        .sliderMax = 720.0,
        .decimals = 0,
    };
}

Parameter top()
{
    return {
        .id = "top",
        .name = Text::tr("Top speed"),
        .unit = Text::tr("rad/frame"),
        .help = Text::tr("The fastest that keys and pointer make the gait clock."),
        .defaultValue = 0.15,
        .min = 0.0,
        .max = 10.0,
        .sliderMin = 0.0,
        .sliderMax = 0.3,
        .decimals = 3,
    };
}

Parameter change()
{
    return {
        .id = "change",
        .name = Text::tr("Change"),
        .unit = Text::tr("rad/frame²"),
        .help = Text::tr("How much speed an arrow key adds or takes away, each frame that it is down."),
        .defaultValue = 0.0025,
        .min = 0.0,
        .max = 10.0,
        .sliderMin = 0.0,
        .sliderMax = 0.02,
        .decimals = 4,
    };
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
    return count({
        .id = "creatures",
        .name = Text::tr("Creatures"),
        .help = Text::tr("How many creatures there are."),
        .defaultValue = 2.0,
        .max = 5.0,
    });
}

Parameter push()
{
    return {
        .id = "push",
        .name = Text::tr("Push"),
        .symbol = "k",
        .unit = Text::tr("1/frame²"),
        .help = Text::tr("How hard two bodies push: this share of the missing distance, each frame."),
        .defaultValue = 0.1,
        .min = 0.0,
        .max = 1e9,
        .sliderMin = 0.0,
        .sliderMax = 0.5,
    };
}

Parameter distance()
{
    return inPixels({
        .id = "distance",
        .name = Text::tr("Distance"),
        .help = Text::tr("Two bodies closer than this push each other."),
        .defaultValue = 60.0,
        .sliderMin = 0.0,
        .sliderMax = 150.0,
    });
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

std::vector<Parameter> sideWalls()
{
    std::vector<Parameter> all = room();
    all.pop_back(); // the floor
    return all;
}

std::vector<Preset> gaits()
{
    return {
        {
            .title = Text::tr("Centipede"),
            .help = Text::tr("Twelve feet, one after the other: the body glides."),
            .values = {{"feet", 12.0}},
        },
        {
            .title = Text::tr("Trot"),
            .help = Text::tr("Four feet in two pairs: it bobs like one with two feet."),
            .values = {{"feet", 4.0}, {"spread", 720.0}},
        },
        {
            .title = Text::tr("Limp"),
            .help = Text::tr("Three feet close behind each other, then a pause."),
            .values = {{"feet", 3.0}, {"spread", 180.0}},
        },
        {
            .title = Text::tr("Runner"),
            .help = Text::tr("A fast clock: no foot touches the ground for long."),
            .values = {{"feet", 4.0}, {"speed", 0.15}},
        },
    };
}

}
