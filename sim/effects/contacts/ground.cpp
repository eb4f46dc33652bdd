#include "sim/effects/contacts/ground.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

Ground::Ground(std::vector<int> feet, Soil soil) : m_feet(std::move(feet)), m_soil(soil)
{
    std::sort(m_feet.begin(), m_feet.end());
    for (const int foot : m_feet) {
        if (!m_runs.empty() && m_runs.back().end() == foot)
            ++m_runs.back().count;
        else
            m_runs.push_back({foot, 1});
    }
}

std::vector<Region> Ground::regions(Directions) const
{
    return {{"sim/effects/contacts/ground.h", "ground"}};
}

/// Calls `visit(foot)` for each foot among `points` that is not held.
template <class Visit>
void Ground::forEach(const State &state, Points points, Visit &&visit) const
{
    auto foot = std::lower_bound(m_feet.begin(), m_feet.end(), points.first);
    for (; foot != m_feet.end() && *foot < points.end(); ++foot) {
        if (state.feels(*foot))
            visit(*foot);
    }
}

int Ground::count(const State &state, Points points) const
{
    int total = 0;
    forEach(state, points, [&](int) { ++total; });
    return total;
}

std::vector<Surface> Ground::surfaces(int point) const
{
    if (!std::binary_search(m_feet.begin(), m_feet.end(), point))
        return {};
    const Grip grip = m_soil.traction == Traction::full ? Grip::full : Grip::none;
    return {{{0.0, -1.0}, -m_soil.ground, m_soil.bounce, grip}};
}

void Ground::resolve(State &state, Points points) const
{
    const Columns x(state.position), v(state.velocity);
    for (const Points &run : m_runs)
        replaceFreeMotion(state, common(run, points),
                          [=, soil = m_soil](int foot) { return sim::ground(x.at(foot), v.at(foot), soil); });
}

bool Ground::takeInto(Taken &into) const
{
    into.choose("ground", {{"ground", m_soil.ground}});
    if (m_soil.bounce != 0.0)
        into.leave(SIM_TEXT("the bounce of the ground"));
    if (m_soil.traction != Traction::full)
        into.leave(SIM_TEXT("ice on the ground"));
    return true;
}

namespace {

constexpr Setting groundSettings[] = {{
    .id = "ground",
    .name = SIM_TEXT("Ground"),
    .unit = SIM_TEXT("px"),
    .help = SIM_TEXT("How far down the ground lies."),
    .preset = 380.0,
    .min = -1e6,
    .max = 1e6,
    .sliderMin = 0.0,
    .sliderMax = 440.0,
    .decimals = 0,
}};

EffectPtr buildGround(const Blueprint &plan, const Values &values)
{
    Soil soil;
    soil.ground = values["ground"];
    return std::make_shared<Ground>(feetOf(plan), soil);
}

}

namespace described {
constinit const Description ground = {
    .id = "ground",
    .title = SIM_TEXT("ground"),
    .kind = Kind::contact,
    .purpose = SIM_TEXT("Keeps the feet from sinking in, and from slipping where it holds them."),
    .settings = groundSettings,
    .make = buildGround};
}

}
