#include "lessons/api/parameters.h"

#include "sim/effects/contacts/ground.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"

#include <QCoreApplication>

#include <algorithm>

namespace lessons {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Parameters)
};

}

Parameter inPixels(Parameter parameter)
{
    parameter.unit = Text::tr("px");
    parameter.min = -1e6;
    parameter.max = 1e6;
    parameter.decimals = 0;
    return parameter;
}

Parameter parameterFromSpec(const sim::ParameterSpec &spec)
{
    const auto translated = [](const char *text) {
        return *text ? QCoreApplication::translate("sim", text) : QString();
    };
    Parameter parameter;
    parameter.id = QString::fromUtf8(spec.id);
    parameter.name = translated(spec.name);
    parameter.symbol = QString::fromUtf8(spec.symbol);
    parameter.unit = translated(spec.unit);
    parameter.help = translated(spec.help);
    parameter.defaultValue = spec.defaultValue;
    parameter.min = spec.min;
    parameter.max = spec.max;
    parameter.sliderMin = spec.sliderMin;
    parameter.sliderMax = spec.sliderMax;
    parameter.decimals = spec.decimals;
    parameter.isInteger = spec.isInteger;
    parameter.role = spec.role;
    return parameter;
}

std::vector<Parameter> parametersOf(std::span<const sim::EffectDescription *const> known)
{
    std::vector<Parameter> all;
    for (const sim::EffectDescription *effect : known) {
        for (const sim::ParameterSpec &spec : effect->parameters) {
            const QString id = QString::fromUtf8(spec.id);
            auto found = std::find_if(all.begin(), all.end(),
                                      [&](const Parameter &parameter) { return parameter.id == id; });
            if (found == all.end())
                found = all.insert(all.end(), parameterFromSpec(spec));
            found->effects << QString::fromUtf8(effect->id);
        }
    }
    return all;
}

Parameter effectParameter(const sim::EffectDescription &effect, const char *id, double defaultValue)
{
    const auto found =
        std::find_if(effect.parameters.begin(), effect.parameters.end(),
                     [id](const auto &parameter) { return std::string_view(parameter.id) == id; });
    Parameter parameter = parameterFromSpec(*found);
    parameter.defaultValue = defaultValue;
    return parameter;
}

Parameter stiffness(double defaultValue)
{
    return {
        .id = "k",
        .name = Text::tr("Stiffness"),
        .symbol = "k",
        .unit = Text::tr("1/frame²"),
        .help = Text::tr("How hard a spring pulls: this share of the missing distance, each frame."),
        .defaultValue = defaultValue,
        .min = 0.0,
        .max = 1e9,
        .sliderMin = 0.0,
        .sliderMax = 1.0,
    };
}

Parameter damping(double defaultValue)
{
    return effectParameter(sim::descriptions::damping, "damp", defaultValue);
}

Parameter radius(double defaultValue)
{
    return {
        .id = "radius",
        .name = Text::tr("Radius"),
        .unit = Text::tr("px"),
        .help = Text::tr("The distance that the spring keeps."),
        .defaultValue = defaultValue,
        .min = 0.0,
        .max = 1e6,
        .sliderMin = 0.0,
        .sliderMax = 150.0,
        .decimals = 0,
    };
}

Parameter offset(double defaultValue)
{
    return {
        .id = "offset",
        .name = Text::tr("Offset"),
        .unit = Text::tr("px"),
        .help = Text::tr("How far to the right of the body the spring ends. Below 0: to the left."),
        .defaultValue = defaultValue,
        .min = -1e6,
        .max = 1e6,
        .sliderMin = -150.0,
        .sliderMax = 150.0,
        .decimals = 0,
    };
}

Parameter feet(int defaultValue)
{
    return {
        .id = "feet",
        .name = Text::tr("Feet"),
        .help = Text::tr("How many feet the body has."),
        .defaultValue = double(defaultValue),
        .min = 1.0,
        .max = 100.0,
        .sliderMin = 1.0,
        .sliderMax = 24.0,
        .decimals = 0,
        .isInteger = true,
    };
}

Parameter gravity(double defaultValue)
{
    return effectParameter(sim::descriptions::gravity, "gravity", defaultValue);
}

Parameter bounce(double defaultValue)
{
    return effectParameter(sim::descriptions::walls, "bounce", defaultValue);
}

Parameter ground(double defaultValue)
{
    return effectParameter(sim::descriptions::ground, "ground", defaultValue);
}

Parameter choice(const char *id, const QString &name, const QString &help, const QStringList &choices)
{
    const double last = double(choices.size() - 1);
    return {
        .id = id,
        .name = name,
        .help = help,
        .defaultValue = 0.0,
        .min = 0.0,
        .max = last,
        .sliderMin = 0.0,
        .sliderMax = last,
        .decimals = 0,
        .choices = choices,
        .isInteger = true,
    };
}

std::vector<Parameter> centre()
{
    return {
        inPixels({
            .id = "centre_x",
            .name = Text::tr("Centre x"),
            .help = Text::tr("How far to the right the cross is."),
            .defaultValue = 270.0,
            .sliderMax = 540.0,
        }),
        inPixels({
            .id = "centre_y",
            .name = Text::tr("Centre y"),
            .help = Text::tr("How far down the cross is."),
            .defaultValue = 200.0,
            .sliderMax = 400.0,
        }),
    };
}

std::vector<Parameter> room()
{
    return {parameterFromSpec(sim::settings::left), parameterFromSpec(sim::settings::right),
            parameterFromSpec(sim::settings::floor)};
}

}
