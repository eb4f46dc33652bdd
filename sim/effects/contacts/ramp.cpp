#include "sim/effects/contacts/ramp.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

#include <cmath>
#include <numbers>

namespace sim {

Incline inclineOf(Vec2 through, double angle, double bounce)
{
    const double radians = angle / 180.0 * std::numbers::pi;
    return {through, {-std::sin(radians), -std::cos(radians)}, bounce};
}

std::vector<Region> Ramp::regions(DirectionRule) const
{
    return {{"sim/effects/contacts/ramp.h", "ramp"}, {"sim/effects/contacts/reflection.h", "reflection"}};
}

int Ramp::count(const State &state, PointRange points) const
{
    return countDynamic(state, points);
}

std::vector<Surface> Ramp::surfaces(int point) const
{
    return {{m_edge.normal, dot(m_edge.through, m_edge.normal) + m_halfWidth[point], m_edge.bounce,
             Traction::none}};
}

void Ramp::resolve(State &state, PointRange points) const
{
    const XyColumns x(state.position), v(state.velocity);
    updateDynamicMotion(state, points, [=, half = m_halfWidth.data(), edge = m_edge](int i) {
        return ramp(x.at(i), v.at(i), half[i], edge);
    });
}

bool Ramp::addToDraft(BlueprintDraft &draft) const
{
    const double angle = std::atan2(-m_edge.normal.x, -m_edge.normal.y) * 180.0 / std::numbers::pi;
    draft.addEffect("ramp", {{"ramp", angle},
                             {"ramp_x", m_edge.through.x},
                             {"ramp_y", m_edge.through.y},
                             {"bounce", m_edge.bounce}});
    return true;
}

namespace {

constexpr ParameterSpec rampParameters[] = {
    settings::bounce,
    {
        .id = "ramp",
        .name = SIM_TEXT("Ramp"),
        .unit = SIM_TEXT("°"),
        .help =
            SIM_TEXT("How steeply it rises to the right. 0: level. 90: a wall on the right. 180: a ceiling."),
        .defaultValue = 20.0,
        .min = -180.0,
        .max = 180.0,
        .sliderMin = -180.0,
        .sliderMax = 180.0,
        .decimals = 0,
    },
    {
        .id = "ramp_x",
        .name = SIM_TEXT("Ramp x"),
        .unit = SIM_TEXT("px"),
        .help = SIM_TEXT("How far to the right a place of the ramp is."),
        .defaultValue = 270.0,
        .min = -1e6,
        .max = 1e6,
        .sliderMin = 0.0,
        .sliderMax = 540.0,
        .decimals = 0,
    },
    {
        .id = "ramp_y",
        .name = SIM_TEXT("Ramp y"),
        .unit = SIM_TEXT("px"),
        .help = SIM_TEXT("How far down that place is."),
        .defaultValue = 320.0,
        .min = -1e6,
        .max = 1e6,
        .sliderMin = 0.0,
        .sliderMax = 400.0,
        .decimals = 0,
    }};

EffectPtr makeRamp(const Blueprint &blueprint, const Values &values)
{
    const Vec2 through{values["ramp_x"], values["ramp_y"]};
    return std::make_shared<Ramp>(inclineOf(through, values["ramp"], values["bounce"]),
                                  halfWidths(blueprint));
}

}

namespace descriptions {
constinit const EffectDescription ramp = {
    .id = "ramp",
    .title = SIM_TEXT("ramp"),
    .kind = EffectKind::contact,
    .purpose = SIM_TEXT("Keeps everything on one side of a straight line at any angle."),
    .parameters = rampParameters,
    .make = makeRamp};
}

}
