#include "app/model/sandbox/property_ranges.h"

#include <QCoreApplication>

namespace app {

namespace {

struct PropertyRangesText
{
    Q_DECLARE_TR_FUNCTIONS(PropertyRangesText)
};

}

lessons::Parameter parameterOf(const PropertyRange &named, double preset)
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

PropertyRange x()
{
    return {"x",
            PropertyRangesText::tr("x"),
            PropertyRangesText::tr("px"),
            PropertyRangesText::tr("How far to the right it starts."),
            built::place,
            0};
}

PropertyRange y()
{
    return {"y",
            PropertyRangesText::tr("y"),
            PropertyRangesText::tr("px"),
            PropertyRangesText::tr("How far down it starts."),
            built::place,
            0};
}

PropertyRange vx()
{
    return {"vx",
            PropertyRangesText::tr("Speed x"),
            PropertyRangesText::tr("px/frame"),
            PropertyRangesText::tr("How fast it starts to the right."),
            built::speed,
            1};
}

PropertyRange vy()
{
    return {"vy",
            PropertyRangesText::tr("Speed y"),
            PropertyRangesText::tr("px/frame"),
            PropertyRangesText::tr("How fast it starts downwards."),
            built::speed,
            1};
}

PropertyRange mass()
{
    return {"mass",      PropertyRangesText::tr("Mass"),
            {},          PropertyRangesText::tr("How hard it is to move. Most bodies have 1."),
            built::mass, 2};
}

PropertyRange size()
{
    return {"size",
            PropertyRangesText::tr("Size"),
            PropertyRangesText::tr("px"),
            PropertyRangesText::tr("Its width: walls stop its edge, and the wind pushes against it."),
            built::size,
            0};
}

PropertyRange fixed()
{
    return {"fixed",    PropertyRangesText::tr("Nailed"),
            {},         PropertyRangesText::tr("Whether it is fixed in place."),
            {0.0, 1.0}, 0};
}

PropertyRange stiffness()
{
    return {"k",
            PropertyRangesText::tr("Stiffness"),
            PropertyRangesText::tr("1/frame²"),
            PropertyRangesText::tr(
                "How hard it pulls a body of mass 1: this share of the missing distance in each frame."),
            built::stiffness,
            2};
}

PropertyRange length()
{
    return {"length",
            PropertyRangesText::tr("Length"),
            PropertyRangesText::tr("px"),
            PropertyRangesText::tr("How far apart its two ends should be."),
            built::length,
            0};
}

PropertyRange share()
{
    return {"share",
            PropertyRangesText::tr("Share"),
            {},
            PropertyRangesText::tr(
                "The share of a length error that its first end corrects; the other end corrects the rest."),
            built::share,
            2};
}

PropertyRange angle()
{
    return {"angle",
            PropertyRangesText::tr("Angle"),
            PropertyRangesText::tr("°"),
            PropertyRangesText::tr(
                "The angle of the foot, seen from its body: 0 is left of the body, 90 above it."),
            built::angle,
            0};
}

PropertyRange leg()
{
    return {"leg",
            PropertyRangesText::tr("Leg"),
            PropertyRangesText::tr("px"),
            PropertyRangesText::tr("How long the legs of this gait group are."),
            built::length,
            0};
}

PropertyRange drop()
{
    return {"drop",
            PropertyRangesText::tr("Drop"),
            PropertyRangesText::tr("px"),
            PropertyRangesText::tr("How far below the body the legs of this gait group end."),
            built::drop,
            0};
}

PropertyRange gaitSpeed()
{
    return {"speed",
            PropertyRangesText::tr("Swing"),
            PropertyRangesText::tr("rad/frame"),
            PropertyRangesText::tr(
                "How fast the clock of this gait group turns its legs. 0: they stand still. To walk, "
                "feet need ground."),
            built::gaitSpeed,
            3};
}

PropertyRange gaitStart()
{
    return {"start",
            PropertyRangesText::tr("Begin"),
            PropertyRangesText::tr("rad"),
            PropertyRangesText::tr(
                "The angle at which that clock starts. Groups with different angles step in turn."),
            built::gaitStart,
            2};
}

PropertyRange pullsBody()
{
    return {
        "pulls_body",
        PropertyRangesText::tr("Carries"),
        {},
        PropertyRangesText::tr("Whether the feet push the body back. If they do not, they cannot carry it."),
        {0.0, 1.0},
        0};
}

}

}
