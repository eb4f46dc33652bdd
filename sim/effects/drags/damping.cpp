#include "sim/effects/drags/damping.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

#include <cmath>

namespace sim {

namespace {

/// The factor that a velocity keeps over h frames.
//! [damping]
double kept(double damp, double h)
{
    double keep = std::pow(damp, h);
    return keep;
}
//! [damping]

}

Damping::Damping(double damp) : m_damp(damp), m_keepInOne(kept(damp, 1.0)) {}

Damping::Damping(double damp, PointRange only) : m_damp(damp), m_keepInOne(kept(damp, 1.0)), m_only(only) {}

std::vector<Region> Damping::regions(DirectionRule) const
{
    return {{"sim/effects/drags/damping.cpp", "damping"}, {"sim/effects/drags/damping.h", "damp"}};
}

std::vector<Region> SpinDamping::regions(DirectionRule) const
{
    return {{"sim/effects/drags/damping.cpp", "damping"}, {"sim/effects/drags/damping.h", "damp_spin"}};
}

PointRange Damping::shareOf(PointRange points) const
{
    const int first = std::max(points.first, m_only.first);
    const int count = std::min(points.end(), m_only.end()) - first;
    return count > 0 ? PointRange{first, count} : PointRange{points.first, 0};
}

int Damping::count(const State &state, PointRange points) const
{
    points = shareOf(points);
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void Damping::apply(State &state, PointRange points, double h) const
{
    const double share = velocityFactor(h);
    points = shareOf(points);
    updateDynamic(state.inverseMass, points, state.velocity,
                  [share, v = XyColumns(state.velocity)](int i) { return damp(v.at(i), share); });
    if (state.spin.rows() > 0)
        updateDynamic(state.inverseMass, points, state.spin.data(),
                      [share, spin = state.spin.data()](int i) { return dampSpin(spin[i], share); });
}

std::optional<double> Damping::velocityFactor(PointRange points, double h) const
{
    if (shareOf(points).count < points.count)
        return {};
    return velocityFactor(h);
}

std::optional<double> Damping::dampingRate(int point) const
{
    if (!m_only.contains(point) || m_damp == 1.0)
        return 0.0;
    return -std::log(m_damp);
}

std::vector<LiveValue> Damping::explain(const State &before, const State &after, int point, double h) const
{
    if (!m_only.contains(point))
        return {};
    std::vector<LiveValue> live = {{"keep", kept(m_damp, h), {}}};
    if (after.spin.rows() > 0)
        live.push_back({"spin", after.spin[point], before.spin[point]});
    else
        live.push_back({"v", after.velocityOf(point), before.velocityOf(point)});
    return live;
}

double Damping::velocityFactor(double h) const
{
    return h == 1.0 ? m_keepInOne : kept(m_damp, h);
}

bool Damping::addToDraft(BlueprintDraft &draft) const
{
    for (int i = 1; i < draft.state.pointCount(); ++i) {
        if (dampingRate(i) != dampingRate(0))
            return false; // of some points only
    }
    draft.addEffect("damping", {{"damp", velocityFactor(1.0)}});
    return true;
}

namespace {

constexpr ParameterSpec dampingSettings[] = {{
    .id = "damp",
    .name = SIM_TEXT("Damping"),
    .unit = SIM_TEXT("per frame"),
    .help = SIM_TEXT("The share of its speed that everything keeps each frame. 1 keeps it all."),
    .defaultValue = 0.99,
    .min = 0.0,
    .max = 1.0,
    .sliderMin = 0.0,
    .sliderMax = 1.0,
    .role = ParameterRole::damping,
}};

EffectPtr buildDamping(const Blueprint &, const Values &values)
{
    return std::make_shared<Damping>(values["damp"]);
}

}

namespace descriptions {
constinit const EffectDescription damping = {
    .id = "damping",
    .title = SIM_TEXT("damping"),
    .kind = EffectKind::damping,
    .purpose = SIM_TEXT("Takes a share of every velocity each frame, so that things come to rest."),
    .parameters = dampingSettings,
    .make = buildDamping};
}

}
