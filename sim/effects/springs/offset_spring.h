#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/spring.h"

namespace sim {

namespace descriptions {
extern const EffectDescription offset_spring;
}

/// A place beside a point. Published: Creatures I, step 6.
// Shown lines are short.
// clang-format off
inline
//! [offset_target]
Vec2 offsetTarget(Vec2 anchor, double offset)
{
    Vec2 target = anchor;
    target.x += offset;
    return target;
}
//! [offset_target]
// clang-format on

/// Springs from points to places that lie `offset` pixels to the right of other points. To and fro between two points
/// both are pulled to the right: so each link is computed by itself.
struct OffsetLaw
{
    struct Numbers
    {
        double k = 0.0;      ///< 1/frame^2
        double offset = 0.0; ///< px
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = false;

    static Vec2 target(Vec2 anchor, const Numbers &one) { return offsetTarget(anchor, one.offset); }
    static PairPull pull(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return {published(mover, anchor, one)};
    }
    static Vec2 pullWhenCoincident(Vec2, const Numbers &) { return {}; }
    static Vec2 published(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return spring(mover, target(anchor, one), one.k).pull;
    }
    static std::vector<Region> regions(DirectionRule)
    {
        return {{"sim/effects/springs/offset_spring.h", "offset_target"},
                {"sim/effects/pairs/spring.h", "spring"}};
    }
    static bool isIdle(const Numbers &one) { return one.k == 0.0; }
    static PairJacobian jacobian(Vec2, Vec2, const Numbers &one) { return pointSpringJacobian(one.k); }
    static double energy(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return springEnergy(length(target(anchor, one) - mover), one.k);
    }
    static std::vector<LiveValue> liveValues(Vec2 mover, Vec2 anchor, Vec2, const Numbers &one, DirectionRule)
    {
        const SpringPull s = spring(mover, target(anchor, one), one.k);
        return {{"target", target(anchor, one)}, {"d", s.d}, {"pull", s.pull}};
    }
    static RestTarget rest(const State &state, const PointPair &link, const Numbers &one)
    {
        return {link.mover, link.anchor, target(state.positionOf(link.anchor), one), false};
    }
};

extern template class PairForce<OffsetLaw>;

class OffsetSpring : public DescribedEffect<PairForce<OffsetLaw>, descriptions::offset_spring>
{
public:
    /// k in 1/frame^2, offset in px.
    OffsetSpring(const std::vector<Link> &links, double k, double offset)
        : DescribedEffect({}, pairsOf(links), {{k, offset}})
    {
    }
};

}
