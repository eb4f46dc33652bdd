#pragma once

#include "sim/effects/contacts/walls.h"

#include <cmath>
#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription ground;
}

/// What the ground does to the speed of a foot along it.
enum class Traction {
    full, ///< takes all of it
    none, ///< takes nothing: ice
};

/// An endless level ground.
struct GroundPlane
{
    double ground = 0.0; ///< px, how far down it lies
    double bounce = 0.0; ///< share of the speed into the ground that is kept, turned round
    Traction traction = Traction::full;
};

/// Puts a foot that is below the ground back onto it. A place is the lowest point of a foot, so no width counts.
/// Without bounce nothing is left of the speed into the ground: 0, and not −0, so `bounce` takes away
/// instead of turning round. Published with bounce 0 and full traction: Creatures II, step 11.
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

/// Ground for some points: the feet. Nothing else meets it.
class Ground : public DescribedEffect<Contact, descriptions::ground>
{
public:
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
    void forEach(const State &state, PointRange points, Visit &&visit) const;

    std::vector<int> m_feet;          ///< in order
    std::vector<PointRange> m_ranges; ///< the same feet
    GroundPlane m_plane;
};

}
