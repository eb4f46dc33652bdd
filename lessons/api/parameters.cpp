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

/// Returns `own` as a coordinate on the stage, which is `sliderMax` px wide or high.
Parameter place(Parameter own)
{
    own.unit = Text::tr("px");
    own.min = -1e6;
    own.max = 1e6;
    own.decimals = 0;
    return own;
}

}

Parameter parameterOf(const sim::Setting &setting)
{
    const auto said = [](const char *text) {
        return *text ? QCoreApplication::translate("sim", text) : QString();
    };
    Parameter parameter;
    parameter.id = QString::fromUtf8(setting.id);
    parameter.name = said(setting.name);
    parameter.symbol = QString::fromUtf8(setting.symbol);
    parameter.unit = said(setting.unit);
    parameter.help = said(setting.help);
    parameter.preset = setting.preset;
    parameter.min = setting.min;
    parameter.max = setting.max;
    parameter.sliderMin = setting.sliderMin;
    parameter.sliderMax = setting.sliderMax;
    parameter.decimals = setting.decimals;
    parameter.whole = setting.whole;
    parameter.role = setting.meaning;
    return parameter;
}

std::vector<Parameter> settingsOf(std::span<const sim::Description *const> known)
{
    std::vector<Parameter> all;
    for (const sim::Description *effect : known) {
        for (const sim::Setting &setting : effect->settings) {
            const QString id = QString::fromUtf8(setting.id);
            auto found =
                std::find_if(all.begin(), all.end(), [&](const Parameter &one) { return one.id == id; });
            if (found == all.end())
                found = all.insert(all.end(), parameterOf(setting));
            found->effects << QString::fromUtf8(effect->id);
        }
    }
    return all;
}

Parameter settingOf(const sim::Description &effect, const char *id, double preset)
{
    const auto found = std::find_if(effect.settings.begin(), effect.settings.end(),
                                    [id](const auto &one) { return std::string_view(one.id) == id; });
    Parameter parameter = parameterOf(*found);
    parameter.preset = preset;
    return parameter;
}

Parameter stiffness(double preset)
{
    return {
        .id = "k",
        .name = Text::tr("Stiffness"),
        .symbol = "k",
        .unit = Text::tr("1/frame²"),
        .help = Text::tr("How hard a spring pulls: this share of the missing distance, each frame."),
        .preset = preset,
        .min = 0.0,
        .max = 1e9,
        .sliderMin = 0.0,
        .sliderMax = 1.0,
    };
}

Parameter damping(double preset)
{
    return settingOf(sim::described::damping, "damp", preset);
}

Parameter radius(double preset)
{
    return {
        .id = "radius",
        .name = Text::tr("Radius"),
        .unit = Text::tr("px"),
        .help = Text::tr("The distance that the spring keeps."),
        .preset = preset,
        .min = 0.0,
        .max = 1e6,
        .sliderMin = 0.0,
        .sliderMax = 150.0,
        .decimals = 0,
    };
}

Parameter offset(double preset)
{
    return {
        .id = "offset",
        .name = Text::tr("Offset"),
        .unit = Text::tr("px"),
        .help = Text::tr("How far to the right of the body the spring ends. Below 0: to the left."),
        .preset = preset,
        .min = -1e6,
        .max = 1e6,
        .sliderMin = -150.0,
        .sliderMax = 150.0,
        .decimals = 0,
    };
}

Parameter feet(int preset)
{
    return {
        .id = "feet",
        .name = Text::tr("Feet"),
        .help = Text::tr("How many feet the body has."),
        .preset = double(preset),
        .min = 1.0,
        .max = 100.0,
        .sliderMin = 1.0,
        .sliderMax = 24.0,
        .decimals = 0,
        .whole = true,
    };
}

Parameter gravity(double preset)
{
    return settingOf(sim::described::gravity, "gravity", preset);
}

Parameter bounce(double preset)
{
    return settingOf(sim::described::walls, "bounce", preset);
}

Parameter ground(double preset)
{
    return settingOf(sim::described::ground, "ground", preset);
}

Parameter choice(const char *id, const QString &name, const QString &help, const QStringList &choices)
{
    const double last = double(choices.size() - 1);
    return {
        .id = id,
        .name = name,
        .help = help,
        .preset = 0.0,
        .min = 0.0,
        .max = last,
        .sliderMin = 0.0,
        .sliderMax = last,
        .decimals = 0,
        .choices = choices,
        .whole = true,
    };
}

std::vector<Parameter> centre()
{
    return {
        place({
            .id = "centre_x",
            .name = Text::tr("Centre x"),
            .help = Text::tr("How far to the right the cross is."),
            .preset = 270.0,
            .sliderMax = 540.0,
        }),
        place({
            .id = "centre_y",
            .name = Text::tr("Centre y"),
            .help = Text::tr("How far down the cross is."),
            .preset = 200.0,
            .sliderMax = 400.0,
        }),
    };
}

std::vector<Parameter> room()
{
    return {parameterOf(sim::settings::left), parameterOf(sim::settings::right),
            parameterOf(sim::settings::floor)};
}

}
