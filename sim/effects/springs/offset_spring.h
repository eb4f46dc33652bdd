#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/spring.h"

namespace sim {

namespace descriptions {
extern const EffectDescription offset_spring;
}

/// Returns the position `offset` px to the right of `anchor`. Published: Creatures I, step 6.
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

/// Springs from points to positions `offset` px to the right of other points. Opposite links between two
/// points pull both to the right, so the law is not symmetric.
struct OffsetLaw
{
    struct Numbers
    {
        double k = 0.0;      ///< mass/frame^2
        double offset = 0.0; ///< px
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = false;

    static Vec2 target(Vec2 anchor, const Numbers &numbers) { return offsetTarget(anchor, numbers.offset); }
    static PairPull pull(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return {published(mover, anchor, numbers)};
    }
    static Vec2 pullWhenCoincident(Vec2, const Numbers &) { return {}; }
    static Vec2 published(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return spring(mover, target(anchor, numbers), numbers.k).pull;
    }
    static std::vector<Region> regions(DirectionRule)
    {
        return {{"sim/effects/springs/offset_spring.h", "offset_target"},
                {"sim/effects/pairs/spring.h", "spring"}};
    }
    static bool isIdle(const Numbers &numbers) { return numbers.k == 0.0; }
    static PairJacobian jacobian(Vec2, Vec2, const Numbers &numbers)
    {
        return pointSpringJacobian(numbers.k);
    }
    static double energy(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return springEnergy(length(target(anchor, numbers) - mover), numbers.k);
    }
    static std::vector<LiveValue> liveValues(Vec2 mover, Vec2 anchor, Vec2, const Numbers &numbers,
                                             DirectionRule)
    {
        const SpringPull s = spring(mover, target(anchor, numbers), numbers.k);
        return {{"target", target(anchor, numbers)}, {"d", s.d}, {"pull", s.pull}};
    }
    static RestTarget restTarget(const State &state, const PointPair &link, const Numbers &numbers)
    {
        return {link.mover, link.anchor, target(state.positionOf(link.anchor), numbers), false};
    }
};

extern template class PairForce<OffsetLaw>;

class OffsetSpring : public DescribedEffect<PairForce<OffsetLaw>, descriptions::offset_spring>
{
public:
    /// k in mass/frame^2, offset in px.
    OffsetSpring(const std::vector<Link> &links, double k, double offset)
        : DescribedEffect({}, pairsOf(links), {{k, offset}})
    {
    }
};

}
