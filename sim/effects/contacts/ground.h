#pragma once

#include "sim/effects/contacts/walls.h"

#include <cmath>
#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription ground;
}

/// A level ground without end.
struct GroundPlane
{
    double ground = 0.0; ///< px, y of the ground
    double bounce = 0.0; ///< restitution: fraction of the normal velocity that remains, reversed
    Traction traction = Traction::full;
};

/// Returns the motion of a foot after it met the ground. A foot below the ground moves up to it. A foot has
/// no width: its position is its lowest point. The formula subtracts from the velocity instead of negating
/// it, so that bounce 0 gives 0 and not −0. Published with bounce 0 and full traction: Creatures II, step 11.
// Shown lines are short.
// clang-format off
inline
//! [ground]
PointMotion ground(
    Vec2 x, Vec2 v, const GroundPlane &plane)
{
    if (x.y > plane.ground) {
        x.y = plane.ground;
        v.y -= (1 + plane.bounce) * v.y;
        if (plane.traction == Traction::full)
            v.x = 0;
    }
    return {x, v};
}
//! [ground]
// clang-format on

/// The ground, for the feet only. Other points pass through it.
class Ground : public DescribedEffect<Contact, descriptions::ground>
{
public:
    /// `feet`: indices of the points that meet the ground, in any order.
    Ground(std::vector<int> feet, GroundPlane plane);

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    bool isIdle() const override { return std::isinf(m_plane.ground) && m_plane.ground > 0.0; }
    void resolve(State &state, PointRange points) const override;
    std::vector<Surface> surfaces(int point) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const GroundPlane &plane() const { return m_plane; }

private:
    template <class Visit>
    void forEachFoot(const State &state, PointRange points, Visit &&visit) const;

    std::vector<int> m_feet;          ///< in ascending order
    std::vector<PointRange> m_ranges; ///< the same feet as ranges
    GroundPlane m_plane;
};

}
