#pragma once

#include "sim/effects/contacts/reflection.h"
#include "sim/effects/contacts/walls.h"

namespace sim {

namespace descriptions {
extern const EffectDescription ramp;
}

/// A straight edge without an end, which leans as it likes.
struct Incline
{
    Vec2 through;        ///< px, a place that it goes through
    Vec2 normal;         ///< of length 1, to the side where bodies are
    double bounce = 0.0; ///< share of the speed into it that is kept, turned round
};

/// `angle` in degrees: 0 is level, with bodies above it; 45 rises to the right; 90 is a wall on the right, and 180 a
/// ceiling.
Incline inclineOf(Vec2 through, double angle, double bounce);

/// Puts a body that is past the edge back to where it touches it, and turns the part of its velocity round that goes into
/// it. `half` is half the body's width.
// Shown lines are short.
// clang-format off
inline
//! [ramp]
PointMotion ramp(
    Vec2 x, Vec2 v, double half,
    const Incline &edge)
{
    Vec2 n = edge.normal;
    Vec2 from = x - edge.through;
    double gap = dot(from, n) - half;
    if (gap < 0)
        x = x - gap * n;
    if (gap < 0 && dot(v, n) < 0)
        v = reflected(v, n, edge.bounce);
    return {x, v};
}
//! [ramp]
// clang-format on

/// A slanted wall without friction, which bodies slide along.
class Ramp : public DescribedEffect<Contact, descriptions::ramp>
{
public:
    /// `half`: half of each point's width in px, one row per point.
    Ramp(Incline edge, Eigen::ArrayXd half) : m_edge(edge), m_half(std::move(half)) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void resolve(State &state, PointRange points) const override;
    std::vector<Surface> surfaces(int point) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const Incline &edge() const { return m_edge; }

private:
    Incline m_edge;
    Eigen::ArrayXd m_half;
};

}
