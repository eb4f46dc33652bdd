#include "sim/effects/contacts/ground.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

Ground::Ground(std::vector<int> feet, GroundPlane plane) : m_feet(std::move(feet)), m_plane(plane)
{
    std::sort(m_feet.begin(), m_feet.end());
    for (const int foot : m_feet) {
        if (!m_ranges.empty() && m_ranges.back().end() == foot)
            ++m_ranges.back().count;
        else
            m_ranges.push_back({foot, 1});
    }
}

std::vector<Region> Ground::regions(DirectionRule) const
{
    return {{"sim/effects/contacts/ground.h", "ground"}};
}

/// Calls `visit(foot)` for each dynamic foot among `points`.
template <class Visit>
void Ground::forEachFoot(const State &state, PointRange points, Visit &&visit) const
{
    auto foot = std::lower_bound(m_feet.begin(), m_feet.end(), points.first);
    for (; foot != m_feet.end() && *foot < points.end(); ++foot) {
        if (state.isDynamic(*foot))
            visit(*foot);
    }
}

int Ground::count(const State &state, PointRange points) const
{
    int total = 0;
    forEachFoot(state, points, [&](int) { ++total; });
    return total;
}

std::vector<Surface> Ground::surfaces(int point) const
{
    if (!std::binary_search(m_feet.begin(), m_feet.end(), point))
        return {};
    return {{{0.0, -1.0}, -m_plane.ground, m_plane.bounce, m_plane.traction}};
}

void Ground::resolve(State &state, PointRange points) const
{
    const XyColumns x(state.position), v(state.velocity);
    for (const PointRange &range : m_ranges)
        updateDynamicMotion(state, intersection(range, points), [=, plane = m_plane](int foot) {
            return sim::ground(x.at(foot), v.at(foot), plane);
        });
}

bool Ground::addToDraft(BlueprintDraft &draft) const
{
    draft.addEffect("ground", {{"ground", m_plane.ground}});
    if (m_plane.bounce != 0.0)
        draft.omit(SIM_TEXT("the bounce of the ground"));
    if (m_plane.traction != Traction::full)
        draft.omit(SIM_TEXT("ice on the ground"));
    return true;
}

namespace {

constexpr ParameterSpec groundParameters[] = {{
    .id = "ground",
    .name = SIM_TEXT("Ground"),
    .unit = SIM_TEXT("px"),
    .help = SIM_TEXT("How far down the ground lies."),
    .defaultValue = 380.0,
    .min = -1e6,
    .max = 1e6,
    .sliderMin = 0.0,
    .sliderMax = 440.0,
    .decimals = 0,
}};

EffectPtr makeGround(const Blueprint &blueprint, const Values &values)
{
    GroundPlane plane;
    plane.ground = values["ground"];
    return std::make_shared<Ground>(feetOf(blueprint), plane);
}

}

namespace descriptions {
constinit const EffectDescription ground = {
    .id = "ground",
    .title = SIM_TEXT("ground"),
    .kind = EffectKind::contact,
    .purpose = SIM_TEXT("Keeps feet from sinking into the ground, and from slipping unless it is icy."),
    .parameters = groundParameters,
    .make = makeGround};
}

}
