#include "sim/effects/fields/breeze.h"

#include "sim/effects/pairs/pair_jacobian.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

namespace sim {

std::vector<Region> Breeze::regions(Directions) const
{
    return {{"sim/effects/fields/breeze.h", "breeze"}};
}

int Breeze::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void Breeze::add(const State &state, Points movers, double scale, Directions, Eigen::ArrayX2d &into) const
{
    double *sideways = into.data(); // the column of x
    replaceFree(state.inverseMass, movers, sideways, [&](int i) {
        return sideways[i] + scale * (state.inverseMass[i] * pullOn(state, i).pull.x);
    });
}

bool Breeze::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    for (int i = movers.first; i < movers.end(); ++i) {
        if (!state.feels(i))
            continue;
        const double turns = std::cos(state.gait[m_clock] - state.at(i).x / 100) / 100;
        const double slope = -m_air.wind * m_air.gusts * turns * m_width[i] / 10;
        addSlope(into, i, i, {scale * state.inverseMass[i] * slope, 0.0, 0.0, 0.0});
    }
    return true;
}

std::vector<Live> Breeze::explain(const State &state, int mover, Directions) const
{
    if (!state.feels(mover))
        return {};
    const BreezePull b = pullOn(state, mover);
    return {{"swell", b.swell}, {"pull", state.inverseMass[mover] * b.pull}};
}

bool Breeze::takeInto(Taken &into) const
{
    into.choose("breeze", {{"wind", m_air.wind}, {"gusts", m_air.gusts}});
    return true;
}

namespace {

constexpr Setting breezeSettings[] = {
    {
        .id = "wind",
        .name = SIM_TEXT("Wind"),
        .unit = SIM_TEXT("px/frame²"),
        .help = SIM_TEXT("How hard it blows to the right on a body 10 px wide. Below 0: to the left."),
        .preset = 0.1,
        .min = -1e6,
        .max = 1e6,
        .sliderMin = -1.0,
        .sliderMax = 1.0,
    },
    {
        .id = "gusts",
        .name = SIM_TEXT("Gusts"),
        .help = SIM_TEXT("The share by which the wind swells and ebbs."),
        .preset = 0.5,
        .min = 0.0,
        .max = 1.0,
    }};

EffectPtr buildBreeze(const Blueprint &plan, const Values &values)
{
    return std::make_shared<Breeze>(Air{values["wind"], values["gusts"]}, widths(plan), windClockOf(plan));
}

}

namespace described {
constinit const Description breeze = {
    .id = "breeze",
    .title = SIM_TEXT("wind"),
    .kind = Kind::wind,
    .purpose = SIM_TEXT("Blows everything sideways, wide bodies more, and swells and ebbs."),
    .settings = breezeSettings,
    .make = buildBreeze};
}

}
