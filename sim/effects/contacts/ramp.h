#pragma once

#include "sim/effects/contacts/reflection.h"
#include "sim/effects/contacts/walls.h"

namespace sim {

namespace descriptions {
extern const EffectDescription ramp;
}

/// A straight edge without end, at any angle.
struct Incline
{
    Vec2 through;        ///< px, a point on the edge
    Vec2 normal;         ///< of length 1, towards the side where bodies are
    double bounce = 0.0; ///< restitution: fraction of the normal velocity that remains, reversed
};

/// Returns the edge through `through` (px) that makes `angle` (degrees) with the x axis. An edge at 0 is
/// level with bodies above it, at 45 it rises to the right, at 90 it is a wall on the right, at 180 a
/// ceiling.
Incline inclineOf(Vec2 through, double angle, double bounce);

/// Returns the motion of a body after it met the edge. A body past the edge moves back until it touches the
/// edge. The part of its velocity that points into the edge is reversed. `half`: px, half the body's width.
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

/// An inclined wall without friction. Bodies slide along it.
class Ramp : public DescribedEffect<Contact, descriptions::ramp>
{
public:
    /// `halfWidth`: px, half the width of each point.
    Ramp(Incline edge, Eigen::ArrayXd halfWidth) : m_edge(edge), m_halfWidth(std::move(halfWidth)) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void resolve(State &state, PointRange points) const override;
    std::vector<Surface> surfaces(int point) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const Incline &edge() const { return m_edge; }

private:
    Incline m_edge;
    Eigen::ArrayXd m_halfWidth;
};

}
