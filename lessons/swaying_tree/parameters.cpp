#include "parameters.h"

#include <QCoreApplication>

using lessons::Parameter;
using lessons::Preset;

namespace swaying_tree {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(SwayingTree)
};

}

Parameter formula()
{
    return {"formula",
            Text::tr("Formula"),
            {},
            {},
            Text::tr("What the tutorial’s text means, or what its code prints."),
            0.0,
            0.0,
            1.0,
            0.0,
            1.0,
            0,
            {QStringLiteral("corrected"), QStringLiteral("published")},
            false,
            lessons::Role::none,
            {Text::tr("corrected"), Text::tr("published")}};
}

Parameter baseLength()
{
    return {"base_length",
            Text::tr("Trunk length"),
            {},
            Text::tr("px"),
            Text::tr("How long the trunk is. All branches grow and shrink with it."),
            100.0,
            0.0,
            1e4,
            20.0,
            200.0,
            0,
            {}};
}

Parameter spread()
{
    return {"spread",
            Text::tr("Spread"),
            {},
            Text::tr("°"),
            Text::tr("How far a branch leans away from its parent."),
            30.0,
            -360.0,
            360.0,
            0.0,
            180.0,
            0,
            {}};
}

Parameter slope()
{
    return {"slope",
            Text::tr("Slope"),
            {},
            {},
            Text::tr("How large a branch is, as a share of its parent."),
            0.8,
            0.01,
            10.0,
            0.3,
            0.9,
            2,
            {}};
}

Parameter minScale()
{
    return {"min_scale",
            Text::tr("Smallest branch"),
            {},
            {},
            Text::tr("Branches must be larger than this share of the trunk."),
            0.2,
            0.0,
            10.0,
            0.1,
            1.0,
            2,
            {}};
}

Parameter jitter()
{
    return {"jitter",
            Text::tr("Jitter"),
            {},
            Text::tr("°"),
            Text::tr("How much chance may turn a new branch, to either side."),
            10.0,
            0.0,
            360.0,
            0.0,
            60.0,
            0,
            {}};
}

Parameter ease()
{
    return {"ease",
            Text::tr("Ease"),
            {},
            Text::tr("frames"),
            Text::tr("How slowly a branch turns: each frame by the missing angle divided by this."),
            8.0,
            1.0,
            1e6,
            1.0,
            40.0,
            1,
            {}};
}

Parameter windStrength()
{
    return {"wind",
            Text::tr("Wind"),
            {},
            {},
            Text::tr("How hard the wind blows. 0 is a calm."),
            5.0,
            0.0,
            1e4,
            0.0,
            20.0,
            1,
            {}};
}

Parameter turbulenceAngle()
{
    return {"turbulence",
            Text::tr("Turbulence"),
            {},
            Text::tr("°"),
            Text::tr("How much chance may turn the wind in each frame, to either side."),
            20.0,
            0.0,
            360.0,
            0.0,
            90.0,
            0,
            {}};
}

Parameter gustSpeed()
{
    return {"gust_speed",
            Text::tr("Gust speed"),
            {},
            Text::tr("px/frame"),
            Text::tr("How fast a gust runs outwards from the pointer."),
            12.0,
            0.1,
            1e4,
            2.0,
            60.0,
            0,
            {}};
}

Parameter gusts()
{
    return {"gusts",
            Text::tr("Gusts"),
            {},
            {},
            Text::tr("The share by which the wind swells and ebbs as it runs. 0 is a steady wind."),
            0.6,
            0.0,
            1.0,
            0.0,
            1.0,
            2,
            {}};
}

std::vector<Preset> galleryFor(const lessons::Step &step)
{
    const std::vector<Preset> all = {
        {Text::tr("Poplar"),
         Text::tr("A small spread makes a narrow crown that reaches up."),
         {{"spread", 12.0}, {"jitter", 8.0}, {"slope", 0.77}}},
        {Text::tr("Honeycomb"),
         Text::tr("At 60 degrees without jitter, branches meet and draw a net of hexagons."),
         {{"spread", 60.0}, {"jitter", 0.0}, {"slope", 0.9}, {"min_scale", 0.35}, {"base_length", 46.0}}},
        {Text::tr("City plan"),
         Text::tr("Right angles, each branch 0.71 of its parent: streets that fill a rectangle."),
         {{"spread", 90.0}, {"jitter", 0.0}, {"slope", 0.71}, {"min_scale", 0.04}, {"base_length", 150.0}}},
        {Text::tr("Lace"),
         Text::tr("Turned by 130 degrees, branches fold back on themselves and fill a triangle."),
         {{"spread", 130.0}, {"jitter", 0.0}, {"slope", 0.72}, {"min_scale", 0.05}, {"base_length", 200.0}}},
        {Text::tr("Cauliflower"),
         Text::tr("Short steps and a slow slope: many branches of nearly one size."),
         {{"spread", 22.0}, {"jitter", 6.0}, {"slope", 0.9}, {"min_scale", 0.35}, {"base_length", 50.0}}},
        {Text::tr("Thicket"),
         Text::tr("With a jitter of 90 degrees chance has the last word."),
         {{"spread", 40.0}, {"jitter", 90.0}, {"slope", 0.8}, {"min_scale", 0.2}}},
    };
    std::vector<Preset> gallery;
    for (Preset preset : all) {
        std::erase_if(preset.values, [&](const auto &value) { return !step.parameter(value.first); });
        gallery.push_back(preset);
    }
    return gallery;
}

}
