#include "app/model/built_names.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(BuiltProperties)
};

}

lessons::Parameter parameterOf(const Named &named, double preset)
{
    lessons::Parameter parameter;
    parameter.id = QString::fromLatin1(named.id);
    parameter.name = named.name;
    parameter.unit = named.unit;
    parameter.help = named.help;
    parameter.defaultValue = preset;
    parameter.min = parameter.sliderMin = named.span.min;
    parameter.max = parameter.sliderMax = named.span.max;
    parameter.decimals = named.decimals;
    return parameter;
}

namespace named {

Named x()
{
    return {"x", Text::tr("x"), Text::tr("px"), Text::tr("How far to the right it starts."), built::place, 0};
}

Named y()
{
    return {"y", Text::tr("y"), Text::tr("px"), Text::tr("How far down it starts."), built::place, 0};
}

Named vx()
{
    return {"vx",
            Text::tr("Speed x"),
            Text::tr("px/frame"),
            Text::tr("How fast it starts to the right."),
            built::speed,
            1};
}

Named vy()
{
    return {"vy",
            Text::tr("Speed y"),
            Text::tr("px/frame"),
            Text::tr("How fast it starts downwards."),
            built::speed,
            1};
}

Named mass()
{
    return {"mass",      Text::tr("Mass"),
            {},          Text::tr("How much it takes to move it; a usual body has 1."),
            built::mass, 2};
}

Named size()
{
    return {"size",         Text::tr("Size"),
            Text::tr("px"), Text::tr("Its width: walls stop its edge, and wind takes hold of it."),
            built::size,    0};
}

Named fixed()
{
    return {"fixed", Text::tr("Nailed"), {}, Text::tr("Whether it stays where it is."), {0.0, 1.0}, 0};
}

Named stiffness()
{
    return {"k",
            Text::tr("Stiffness"),
            Text::tr("1/frame²"),
            Text::tr("How hard it pulls a usual body: this share of the missing distance, each frame."),
            built::stiffness,
            2};
}

Named length()
{
    return {"length",       Text::tr("Length"),
            Text::tr("px"), Text::tr("How far apart it wants its two ends."),
            built::length,  0};
}

Named share()
{
    return {
        "share",
        Text::tr("Share"),
        {},
        Text::tr("The part of a wrong length that its first end makes good; the other end does the rest."),
        built::share,
        2};
}

Named angle()
{
    return {
        "angle",       Text::tr("Angle"),
        Text::tr("°"), Text::tr("Where the foot belongs, seen from its body: 0 is left of it, 90 above it."),
        built::angle,  0};
}

Named leg()
{
    return {"leg",          Text::tr("Leg"),
            Text::tr("px"), Text::tr("How long the legs of this gait group are."),
            built::length,  0};
}

Named drop()
{
    return {"drop",         Text::tr("Drop"),
            Text::tr("px"), Text::tr("How far below the body the legs of this gait group end."),
            built::drop,    0};
}

Named gaitSpeed()
{
    return {"speed",
            Text::tr("Swing"),
            Text::tr("rad/frame"),
            Text::tr("How fast the clock of this gait group turns its legs. 0: they stand still. To walk, "
                     "feet need ground."),
            built::gaitSpeed,
            3};
}

Named gaitStart()
{
    return {"start",          Text::tr("Begin"),
            Text::tr("rad"),  Text::tr("Where that clock begins: groups that begin apart step in turn."),
            built::gaitStart, 2};
}

Named pullsBody()
{
    return {"pulls_body", Text::tr("Carries"),
            {},           Text::tr("Whether the body feels its feet: without that they do not carry it."),
            {0.0, 1.0},   0};
}

}

}
