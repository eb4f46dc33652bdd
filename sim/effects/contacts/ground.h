#pragma once

#include "sim/effects/contacts/walls.h"

#include <cmath>
#include <vector>

namespace sim {

namespace described {
extern const Description ground;
}

/// What the ground does to the speed of a foot along it.
enum class Traction {
    full, ///< takes all of it
    none, ///< takes nothing: ice
};

/// An endless level ground.
struct Soil
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
Motion ground(
    Vec2 x, Vec2 v, const Soil &soil)
{
    if (x.y > soil.ground) {
        x.y = soil.ground;
        v.y -= (1 + soil.bounce) * v.y;
        if (soil.traction == Traction::full)
            v.x = 0;
    }
    return {x, v};
}
//! [ground]
// clang-format on

/// Ground for some points: the feet. Nothing else meets it.
class Ground : public Described<Contact, described::ground>
{
public:
    Ground(std::vector<int> feet, Soil soil);

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::tied; }
    bool idle() const override { return std::isinf(m_soil.ground) && m_soil.ground > 0.0; }
    void resolve(State &state, Points points) const override;
    std::vector<Surface> surfaces(int point) const override;
    bool takeInto(Taken &into) const override;

    const Soil &soil() const { return m_soil; }

private:
    template <class Visit>
    void forEach(const State &state, Points points, Visit &&visit) const;

    std::vector<int> m_feet;    ///< in order
    std::vector<Points> m_runs; ///< the same feet
    Soil m_soil;
};

}
