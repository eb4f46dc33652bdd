#include "sim/effects/fields/breeze.h"

#include "sim/effects/pairs/pair_jacobian.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

namespace sim {

std::vector<Region> Breeze::regions(DirectionRule) const
{
    return {{"sim/effects/fields/breeze.h", "breeze"}};
}

int Breeze::count(const State &state, PointRange points) const
{
    return countDynamic(state, points);
}

void Breeze::add(const State &state, PointRange movers, double scale, DirectionRule,
                 Eigen::ArrayX2d &into) const
{
    double *ax = into.data(); // the column of x
    updateDynamic(state.inverseMass, movers, ax,
                  [&](int i) { return ax[i] + scale * (state.inverseMass[i] * pullOn(state, i).pull.x); });
}

bool Breeze::addJacobian(const State &state, PointRange movers, double scale, DirectionRule,
                         Jacobian &jacobian) const
{
    for (int i = movers.first; i < movers.end(); ++i) {
        if (!state.isDynamic(i))
            continue;
        const double swellDerivative = std::cos(state.gait[m_clock] - state.positionOf(i).x / 100) / 100;
        const double derivative = -m_strength.wind * m_strength.gusts * swellDerivative * m_width[i] / 10;
        addJacobianBlock(jacobian, i, i, {scale * state.inverseMass[i] * derivative, 0.0, 0.0, 0.0});
    }
    return true;
}

std::vector<LiveValue> Breeze::explain(const State &state, int mover, DirectionRule) const
{
    if (!state.isDynamic(mover))
        return {};
    const BreezePull b = pullOn(state, mover);
    return {{"swell", b.swell}, {"pull", state.inverseMass[mover] * b.pull}};
}

bool Breeze::addToDraft(BlueprintDraft &draft) const
{
    draft.addEffect("breeze", {{"wind", m_strength.wind}, {"gusts", m_strength.gusts}});
    return true;
}

namespace {

constexpr ParameterSpec breezeParameters[] = {
    {
        .id = "wind",
        .name = SIM_TEXT("Wind"),
        .unit = SIM_TEXT("px/frame²"),
        .help = SIM_TEXT("How hard it blows to the right on a body 10 px wide. Below 0: to the left."),
        .defaultValue = 0.1,
        .min = -1e6,
        .max = 1e6,
        .sliderMin = -1.0,
        .sliderMax = 1.0,
    },
    {
        .id = "gusts",
        .name = SIM_TEXT("Gusts"),
        .help = SIM_TEXT("The share by which the strength of the wind changes."),
        .defaultValue = 0.5,
        .min = 0.0,
        .max = 1.0,
    }};

EffectPtr makeBreeze(const Blueprint &blueprint, const Values &values)
{
    return std::make_shared<Breeze>(BreezeStrength{values["wind"], values["gusts"]}, widths(blueprint),
                                    windClockOf(blueprint));
}

}

namespace descriptions {
constinit const EffectDescription breeze = {
    .id = "breeze",
    .title = SIM_TEXT("wind"),
    .kind = EffectKind::wind,
    .purpose = SIM_TEXT("Blows everything sideways, wide bodies more strongly, and can come in gusts."),
    .parameters = breezeParameters,
    .make = makeBreeze};
}

}
