#include "parameters.h"

#include "lessons/api/parameters.h"
#include "lessons/codeling/text.h"

#include <QCoreApplication>

using lessons::Parameter;

namespace codeling {

namespace {

/// Completes a parameter with the range from 0 to 1.
Parameter share(Parameter parameter)
{
    parameter.min = parameter.sliderMin = 0.0;
    parameter.max = parameter.sliderMax = 1.0;
    return parameter;
}

/// The lead swings on its motor, so this parameter has the role of damping.
Parameter keptByLead()
{
    return share({
        .id = "keep",
        .name = Text::tr("Keep"),
        .unit = Text::tr("per frame"),
        .help = Text::tr("The share of its speed that the lead keeps each frame."),
        .defaultValue = 0.7,
        .role = lessons::ParameterRole::damping,
    });
}

/// Completes a length in pixels.
Parameter pixels(Parameter parameter)
{
    parameter.unit = Text::tr("px");
    parameter.max = 1e6;
    parameter.decimals = 0;
    return parameter;
}

/// Completes a coordinate of the first target.
Parameter coordinate(Parameter parameter)
{
    parameter.defaultValue = 200.0;
    return inPixels(parameter);
}

/// Completes an integer whose slider covers its whole range.
Parameter count(Parameter parameter)
{
    parameter.sliderMin = parameter.min;
    parameter.sliderMax = parameter.max;
    parameter.decimals = 0;
    parameter.isInteger = true;
    return parameter;
}

}

std::vector<Parameter> motorParameters()
{
    return {
        {
            .id = "k",
            .name = Text::tr("Stiffness"),
            .symbol = "k",
            .help = Text::tr("How hard the motor pulls: this times the way to the target."),
            .defaultValue = 0.9,
            .min = 0.0,
            .max = 1e9,
            .sliderMin = 0.0,
            .sliderMax = 4.0,
        },
        keptByLead(),
        {
            .id = "dt",
            .name = Text::tr("Time step"),
            .help = Text::tr("How much of its own time passes in a frame: the pull counts dt × dt."),
            .defaultValue = 0.25,
            .min = 0.0,
            .max = 100.0,
            .sliderMin = 0.0,
            .sliderMax = 1.0,
        },
        coordinate({
            .id = "target_x",
            .name = Text::tr("Target x"),
            .help = Text::tr("How far to the right the first target is."),
            .sliderMax = 540.0,
        }),
        coordinate({
            .id = "target_y",
            .name = Text::tr("Target y"),
            .help = Text::tr("How far down the first target is."),
            .sliderMax = 400.0,
        }),
    };
}

Parameter restLength()
{
    return pixels({
        .id = "rest_length",
        .name = Text::tr("Rest length"),
        .help = Text::tr("How far the tail is from the lead at rest."),
        .defaultValue = 40.0,
        .sliderMax = 120.0,
    });
}

Parameter anticipationPart()
{
    return share({
        .id = "anticipation",
        .name = Text::tr("Anticipation"),
        .help = Text::tr("How far it backs up before a move, as a part of the way to the target."),
        .defaultValue = 0.2,
    });
}

std::vector<Parameter> spineParameters()
{
    const QString perFrame = Text::tr("per frame");
    return {
        share({
            .id = "soft",
            .name = Text::tr("Soft"),
            .unit = perFrame,
            .help = Text::tr("The part of the spine’s error that goes each frame."),
            .defaultValue = 0.1,
        }),
        share({
            .id = "hard",
            .name = Text::tr("Hard"),
            .unit = perFrame,
            .help = Text::tr("The same, when the spine is too short or too long."),
            .defaultValue = 0.8,
        }),
        share({
            .id = "along",
            .name = Text::tr("Along"),
            .unit = perFrame,
            .help = Text::tr("The share of the tail’s speed along the spine that it keeps."),
            .defaultValue = 0.7,
        }),
        share({
            .id = "across",
            .name = Text::tr("Across"),
            .unit = perFrame,
            .help = Text::tr("The share of the tail’s speed across the spine that it keeps."),
            .defaultValue = 0.5,
        }),
        pixels({
            .id = "min_length",
            .name = Text::tr("Shortest length"),
            .help = Text::tr("Shorter than this, the spine pushes hard."),
            .defaultValue = 20.0,
            .sliderMax = 120.0,
        }),
        pixels({
            .id = "max_length",
            .name = Text::tr("Longest length"),
            .help = Text::tr("Longer than this, the spine pulls hard."),
            .defaultValue = 60.0,
            .sliderMax = 120.0,
        }),
    };
}

std::vector<Parameter> tentacleParameters()
{
    return {
        count({
            .id = "tentacles",
            .name = Text::tr("Tentacles"),
            .help = Text::tr("How many tentacles it has."),
            .defaultValue = 4.0,
            .min = 2.0,
            .max = 8.0,
        }),
        count({
            .id = "links",
            .name = Text::tr("Links"),
            .help = Text::tr("How many links each tentacle has."),
            .defaultValue = 10.0,
            .min = 3.0,
            .max = 30.0,
        }),
        share({
            .id = "water",
            .name = Text::tr("Water"),
            .unit = Text::tr("per frame"),
            .help = Text::tr("The share of its speed that a tentacle keeps each frame. Less: thicker water."),
            .defaultValue = 0.9,
        }),
    };
}

}
