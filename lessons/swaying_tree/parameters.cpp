#include "parameters.h"
#include "lessons/swaying_tree/text.h"

#include <QCoreApplication>

using lessons::Parameter;
using lessons::Preset;

namespace swaying_tree {

Parameter formula()
{
    return {
        .id = "formula",
        .name = Text::tr("Formula"),
        .help = Text::tr("What the tutorial’s text means, or what its code prints."),
        .defaultValue = 0.0,
        .min = 0.0,
        .max = 1.0,
        .sliderMin = 0.0,
        .sliderMax = 1.0,
        .decimals = 0,
        .choices = {QStringLiteral("corrected"), QStringLiteral("published")},
        .role = lessons::ParameterRole::none,
        .choiceTitles = {Text::tr("corrected"), Text::tr("published")},
    };
}

Parameter baseLength()
{
    return {
        .id = "base_length",
        .name = Text::tr("Trunk length"),
        .unit = Text::tr("px"),
        .help = Text::tr("How long the trunk is. All branches grow and shrink with it."),
        .defaultValue = 100.0,
        .min = 0.0,
        .max = 1e4,
        .sliderMin = 20.0,
        .sliderMax = 200.0,
        .decimals = 0,
    };
}

Parameter spread()
{
    return {
        .id = "spread",
        .name = Text::tr("Spread"),
        .unit = Text::tr("°"),
        .help = Text::tr("How far a branch leans away from its parent."),
        .defaultValue = 30.0,
        .min = -360.0,
        .max = 360.0,
        .sliderMin = 0.0,
        .sliderMax = 180.0,
        .decimals = 0,
    };
}

Parameter slope()
{
    return {
        .id = "slope",
        .name = Text::tr("Slope"),
        .help = Text::tr("How large a branch is, as a share of its parent."),
        .defaultValue = 0.8,
        .min = 0.01,
        .max = 10.0,
        .sliderMin = 0.3,
        .sliderMax = 0.9,
    };
}

Parameter minScale()
{
    return {
        .id = "min_scale",
        .name = Text::tr("Smallest branch"),
        .help = Text::tr("Branches must be larger than this share of the trunk."),
        .defaultValue = 0.2,
        .min = 0.0,
        .max = 10.0,
        .sliderMin = 0.1,
        .sliderMax = 1.0,
    };
}

Parameter jitter()
{
    return {
        .id = "jitter",
        .name = Text::tr("Jitter"),
        .unit = Text::tr("°"),
        .help = Text::tr("How much chance may turn a new branch, to either side."),
        .defaultValue = 10.0,
        .min = 0.0,
        .max = 360.0,
        .sliderMin = 0.0,
        .sliderMax = 60.0,
        .decimals = 0,
    };
}

Parameter ease()
{
    return {
        .id = "ease",
        .name = Text::tr("Ease"),
        .unit = Text::tr("frames"),
        .help = Text::tr("How slowly a branch turns: each frame by the missing angle divided by this."),
        .defaultValue = 8.0,
        .min = 1.0,
        .max = 1e6,
        .sliderMin = 1.0,
        .sliderMax = 40.0,
        .decimals = 1,
    };
}

Parameter windStrength()
{
    return {
        .id = "wind",
        .name = Text::tr("Wind"),
        .help = Text::tr("How hard the wind blows. 0 is a calm."),
        .defaultValue = 5.0,
        .min = 0.0,
        .max = 1e4,
        .sliderMin = 0.0,
        .sliderMax = 20.0,
        .decimals = 1,
    };
}

Parameter turbulenceAngle()
{
    return {
        .id = "turbulence",
        .name = Text::tr("Turbulence"),
        .unit = Text::tr("°"),
        .help = Text::tr("How much chance may turn the wind in each frame, to either side."),
        .defaultValue = 20.0,
        .min = 0.0,
        .max = 360.0,
        .sliderMin = 0.0,
        .sliderMax = 90.0,
        .decimals = 0,
    };
}

Parameter gustSpeed()
{
    return {
        .id = "gust_speed",
        .name = Text::tr("Gust speed"),
        .unit = Text::tr("px/frame"),
        .help = Text::tr("How fast a gust runs outwards from the pointer."),
        .defaultValue = 12.0,
        .min = 0.1,
        .max = 1e4,
        .sliderMin = 2.0,
        .sliderMax = 60.0,
        .decimals = 0,
    };
}

Parameter gusts()
{
    return {
        .id = "gusts",
        .name = Text::tr("Gusts"),
        .help = Text::tr("The share by which the wind swells and ebbs as it runs. 0 is a steady wind."),
        .defaultValue = 0.6,
        .min = 0.0,
        .max = 1.0,
        .sliderMin = 0.0,
        .sliderMax = 1.0,
    };
}

std::vector<Preset> galleryFor(const lessons::Step &step)
{
    const std::vector<Preset> all = {
        {
            .title = Text::tr("Poplar"),
            .help = Text::tr("A small spread makes a narrow crown that reaches up."),
            .values = {{"spread", 12.0}, {"jitter", 8.0}, {"slope", 0.77}},
        },
        {
            .title = Text::tr("Honeycomb"),
            .help = Text::tr("At 60 degrees without jitter, branches meet and draw a net of hexagons."),
            .values = {{"spread", 60.0},
                       {"jitter", 0.0},
                       {"slope", 0.9},
                       {"min_scale", 0.35},
                       {"base_length", 46.0}},
        },
        {
            .title = Text::tr("City plan"),
            .help = Text::tr("Right angles, each branch 0.71 of its parent: streets that fill a rectangle."),
            .values = {{"spread", 90.0},
                       {"jitter", 0.0},
                       {"slope", 0.71},
                       {"min_scale", 0.04},
                       {"base_length", 150.0}},
        },
        {
            .title = Text::tr("Lace"),
            .help = Text::tr("Turned by 130 degrees, branches fold back on themselves and fill a triangle."),
            .values = {{"spread", 130.0},
                       {"jitter", 0.0},
                       {"slope", 0.72},
                       {"min_scale", 0.05},
                       {"base_length", 200.0}},
        },
        {
            .title = Text::tr("Cauliflower"),
            .help = Text::tr("Short steps and a slow slope: many branches of nearly one size."),
            .values = {{"spread", 22.0},
                       {"jitter", 6.0},
                       {"slope", 0.9},
                       {"min_scale", 0.35},
                       {"base_length", 50.0}},
        },
        {
            .title = Text::tr("Thicket"),
            .help = Text::tr("With a jitter of 90 degrees chance has the last word."),
            .values = {{"spread", 40.0}, {"jitter", 90.0}, {"slope", 0.8}, {"min_scale", 0.2}},
        },
    };
    std::vector<Preset> gallery;
    for (Preset preset : all) {
        std::erase_if(preset.values, [&](const auto &value) { return !step.parameter(value.first); });
        gallery.push_back(preset);
    }
    return gallery;
}

}
