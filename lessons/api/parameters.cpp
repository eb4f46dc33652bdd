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

/// A coordinate on the stage, which is `sliderMax` px wide or high.
Parameter place(const char *id, const QString &name, const QString &help, double preset, double sliderMax)
{
    return {id, name, {}, Text::tr("px"), help, preset, -1e6, 1e6, 0.0, sliderMax, 0, {}};
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
    return {"k",
            Text::tr("Stiffness"),
            "k",
            Text::tr("1/frame²"),
            Text::tr("How hard a spring pulls: this share of the missing distance, each frame."),
            preset,
            0.0,
            1e9,
            0.0,
            1.0,
            2,
            {}};
}

Parameter damping(double preset)
{
    return settingOf(sim::described::damping, "damp", preset);
}

Parameter radius(double preset)
{
    return {"radius",
            Text::tr("Radius"),
            {},
            Text::tr("px"),
            Text::tr("The distance that the spring keeps."),
            preset,
            0.0,
            1e6,
            0.0,
            150.0,
            0,
            {}};
}

Parameter offset(double preset)
{
    return {"offset",
            Text::tr("Offset"),
            {},
            Text::tr("px"),
            Text::tr("How far to the right of the body the spring ends. Below 0: to the left."),
            preset,
            -1e6,
            1e6,
            -150.0,
            150.0,
            0,
            {}};
}

Parameter feet(int preset)
{
    return {"feet",
            Text::tr("Feet"),
            {},
            {},
            Text::tr("How many feet the body has."),
            double(preset),
            1.0,
            100.0,
            1.0,
            24.0,
            0,
            {},
            true};
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
    return {id, name, {}, {}, help, 0.0, 0.0, last, 0.0, last, 0, choices, true};
}

std::vector<Parameter> centre()
{
    return {
        place("centre_x", Text::tr("Centre x"), Text::tr("How far to the right the cross is."), 270.0, 540.0),
        place("centre_y", Text::tr("Centre y"), Text::tr("How far down the cross is."), 200.0, 400.0)};
}

std::vector<Parameter> room()
{
    return {parameterOf(sim::settings::left), parameterOf(sim::settings::right),
            parameterOf(sim::settings::floor)};
}

}
