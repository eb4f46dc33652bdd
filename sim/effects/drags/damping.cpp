#include "sim/effects/drags/damping.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

#include <cmath>

namespace sim {

namespace {

/// Returns the damping factor for `h` frames.
//! [damping]
double kept(double damp, double h)
{
    double keep = std::pow(damp, h);
    return keep;
}
//! [damping]

}

Damping::Damping(double damp) : m_damp(damp), m_factorPerFrame(kept(damp, 1.0)) {}

Damping::Damping(double damp, PointRange range)
    : m_damp(damp), m_factorPerFrame(kept(damp, 1.0)), m_range(range)
{
}

std::vector<Region> Damping::regions(DirectionRule) const
{
    return {{"sim/effects/drags/damping.cpp", "damping"}, {"sim/effects/drags/damping.h", "damp"}};
}

std::vector<Region> SpinDamping::regions(DirectionRule) const
{
    return {{"sim/effects/drags/damping.cpp", "damping"}, {"sim/effects/drags/damping.h", "damp_spin"}};
}

PointRange Damping::dampedPart(PointRange points) const
{
    const int first = std::max(points.first, m_range.first);
    const int count = std::min(points.end(), m_range.end()) - first;
    return count > 0 ? PointRange{first, count} : PointRange{points.first, 0};
}

int Damping::count(const State &state, PointRange points) const
{
    points = dampedPart(points);
    return countDynamic(state, points);
}

void Damping::apply(State &state, PointRange points, double h) const
{
    const double factor = velocityFactor(h);
    points = dampedPart(points);
    updateDynamic(state.inverseMass, points, state.velocity,
                  [factor, v = XyColumns(state.velocity)](int i) { return damp(v.at(i), factor); });
    if (state.spin.rows() > 0)
        updateDynamic(state.inverseMass, points, state.spin.data(),
                      [factor, spin = state.spin.data()](int i) { return dampSpin(spin[i], factor); });
}

std::optional<double> Damping::velocityFactor(PointRange points, double h) const
{
    if (dampedPart(points).count < points.count)
        return {};
    return velocityFactor(h);
}

std::optional<double> Damping::dampingRate(int point) const
{
    if (!m_range.contains(point) || m_damp == 1.0)
        return 0.0;
    return -std::log(m_damp);
}

std::vector<LiveValue> Damping::explain(const State &before, const State &after, int point, double h) const
{
    if (!m_range.contains(point))
        return {};
    std::vector<LiveValue> values = {{"keep", kept(m_damp, h), {}}};
    if (after.spin.rows() > 0)
        values.push_back({"spin", after.spin[point], before.spin[point]});
    else
        values.push_back({"v", after.velocityOf(point), before.velocityOf(point)});
    return values;
}

double Damping::velocityFactor(double h) const
{
    return h == 1.0 ? m_factorPerFrame : kept(m_damp, h);
}

bool Damping::addToDraft(BlueprintDraft &draft) const
{
    for (int i = 1; i < draft.state.pointCount(); ++i) {
        if (dampingRate(i) != dampingRate(0))
            return false; // it damps some points only, and a blueprint cannot express that
    }
    draft.addEffect("damping", {{"damp", velocityFactor(1.0)}});
    return true;
}

namespace {

constexpr ParameterSpec dampingParameters[] = {{
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

EffectPtr makeDamping(const Blueprint &, const Values &values)
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
    .parameters = dampingParameters,
    .make = makeDamping};
}

}
