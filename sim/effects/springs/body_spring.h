#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/spring.h"

namespace sim {

namespace descriptions {
extern const EffectDescription body_spring;
}

/// Springs of rest length 0 from points to other points.
struct BodyLaw
{
    struct Numbers
    {
        double k = 0.0; ///< mass/frame^2
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = true;

    static PairPull pull(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return {published(mover, anchor, numbers)};
    }
    static Vec2 pullWhenCoincident(Vec2, const Numbers &) { return {}; }
    static Vec2 published(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return spring(mover, anchor, numbers.k).pull;
    }
    static std::vector<Region> regions(DirectionRule) { return {{"sim/effects/pairs/spring.h", "spring"}}; }
    static bool isIdle(const Numbers &numbers) { return numbers.k == 0.0; }
    static double restLength(const Numbers &) { return 0.0; }
    static PairJacobian jacobian(Vec2, Vec2, const Numbers &numbers)
    {
        return pointSpringJacobian(numbers.k);
    }
    static double energy(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return springEnergy(length(anchor - mover), numbers.k);
    }
    static std::vector<LiveValue> liveValues(Vec2 mover, Vec2 anchor, Vec2, const Numbers &numbers,
                                             DirectionRule)
    {
        const SpringPull s = spring(mover, anchor, numbers.k);
        return {{"d", s.d}, {"pull", s.pull}};
    }
};

extern template class PairForce<BodyLaw>;

class BodySpring : public DescribedEffect<PairForce<BodyLaw>, descriptions::body_spring>
{
public:
    /// k in mass/frame^2.
    BodySpring(const std::vector<Link> &links, double k) : DescribedEffect({}, pairsOf(links), {{k}}) {}
};

}
