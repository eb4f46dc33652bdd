#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/spring.h"

namespace sim {

namespace descriptions {
extern const EffectDescription body_spring;
}

/// Springs from points to other points, wherever those are.
struct BodyLaw
{
    struct Numbers
    {
        double k = 0.0; ///< 1/frame^2
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = true;

    static PairPull pull(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return {published(mover, anchor, one)};
    }
    static Vec2 pullWhenCoincident(Vec2, const Numbers &) { return {}; }
    static Vec2 published(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return spring(mover, anchor, one.k).pull;
    }
    static std::vector<Region> regions(DirectionRule) { return {{"sim/effects/pairs/spring.h", "spring"}}; }
    static bool isIdle(const Numbers &one) { return one.k == 0.0; }
    static double restLength(const Numbers &) { return 0.0; }
    static PairJacobian jacobian(Vec2, Vec2, const Numbers &one) { return pointSpringJacobian(one.k); }
    static double energy(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return springEnergy(length(anchor - mover), one.k);
    }
    static std::vector<LiveValue> liveValues(Vec2 mover, Vec2 anchor, Vec2, const Numbers &one, DirectionRule)
    {
        const SpringPull s = spring(mover, anchor, one.k);
        return {{"d", s.d}, {"pull", s.pull}};
    }
};

extern template class PairForce<BodyLaw>;

class BodySpring : public DescribedEffect<PairForce<BodyLaw>, descriptions::body_spring>
{
public:
    /// k in 1/frame^2.
    BodySpring(const std::vector<Link> &links, double k) : DescribedEffect({}, pairsOf(links), {{k}}) {}
};

}
