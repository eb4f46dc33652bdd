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

Damping::Damping(double damp, Points only) : m_damp(damp), m_keepInOne(kept(damp, 1.0)), m_only(only) {}

std::vector<Region> Damping::regions(Directions) const
{
    return {{"sim/effects/drags/damping.cpp", "damping"}, {"sim/effects/drags/damping.h", "damp"}};
}

std::vector<Region> SpinDamping::regions(Directions) const
{
    return {{"sim/effects/drags/damping.cpp", "damping"}, {"sim/effects/drags/damping.h", "damp_spin"}};
}

Points Damping::shareOf(Points points) const
{
    const int first = std::max(points.first, m_only.first);
    const int count = std::min(points.end(), m_only.end()) - first;
    return count > 0 ? Points{first, count} : Points{points.first, 0};
}

int Damping::count(const State &state, Points points) const
{
    points = shareOf(points);
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void Damping::slow(State &state, Points points, double h) const
{
    const double share = keep(h);
    points = shareOf(points);
    replaceFree(state.inverseMass, points, state.velocity,
                [share, v = Columns(state.velocity)](int i) { return damp(v.at(i), share); });
    if (state.spin.rows() > 0)
        replaceFree(state.inverseMass, points, state.spin.data(),
                    [share, spin = state.spin.data()](int i) { return dampSpin(spin[i], share); });
}

std::optional<double> Damping::keep(Points points, double h) const
{
    if (shareOf(points).count < points.count)
        return {};
    return keep(h);
}

std::optional<double> Damping::rate(int point) const
{
    if (!m_only.contains(point) || m_damp == 1.0)
        return 0.0;
    return -std::log(m_damp);
}

std::vector<Live> Damping::explain(const State &before, const State &after, int point, double h) const
{
    if (!m_only.contains(point))
        return {};
    std::vector<Live> live = {{"keep", kept(m_damp, h), {}}};
    if (after.spin.rows() > 0)
        live.push_back({"spin", after.spin[point], before.spin[point]});
    else
        live.push_back({"v", after.speed(point), before.speed(point)});
    return live;
}

double Damping::keep(double h) const
{
    return h == 1.0 ? m_keepInOne : kept(m_damp, h);
}

bool Damping::takeInto(Taken &into) const
{
    for (int i = 1; i < into.now.points(); ++i) {
        if (rate(i) != rate(0))
            return false; // of some points only
    }
    into.choose("damping", {{"damp", keep(1.0)}});
    return true;
}

namespace {

constexpr Setting dampingSettings[] = {{
    .id = "damp",
    .name = SIM_TEXT("Damping"),
    .unit = SIM_TEXT("per frame"),
    .help = SIM_TEXT("The share of its speed that everything keeps each frame. 1 keeps it all."),
    .preset = 0.99,
    .min = 0.0,
    .max = 1.0,
    .sliderMin = 0.0,
    .sliderMax = 1.0,
    .meaning = Meaning::keptSpeed,
}};

EffectPtr buildDamping(const Blueprint &, const Values &values)
{
    return std::make_shared<Damping>(values["damp"]);
}

}

namespace described {
constinit const Description damping = {
    .id = "damping",
    .title = SIM_TEXT("damping"),
    .kind = Kind::damping,
    .purpose = SIM_TEXT("Takes a share of every velocity each frame, so that things come to rest."),
    .settings = dampingSettings,
    .make = buildDamping};
}

}
