#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/spring.h"

namespace sim {

namespace described {
extern const Description body_spring;
}

/// Springs from points to other points, wherever those are.
struct BodyLaw
{
    struct Numbers
    {
        double k = 0.0; ///< 1/frame^2
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isMutual = true;

    static Pull pull(Vec2 mover, Vec2 anchor, const Numbers &one) { return {published(mover, anchor, one)}; }
    static Vec2 pullInOnePlace(Vec2, const Numbers &) { return {}; }
    static Vec2 published(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return spring(mover, anchor, one.k).pull;
    }
    static std::vector<Region> regions(Directions) { return {{"sim/effects/pairs/spring.h", "spring"}}; }
    static bool isIdle(const Numbers &one) { return one.k == 0.0; }
    static double restLength(const Numbers &) { return 0.0; }
    static Slope slope(Vec2, Vec2, const Numbers &one) { return slopeToPlace(one.k); }
    static double energy(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return springEnergy(length(anchor - mover), one.k);
    }
    static std::vector<Live> live(Vec2 mover, Vec2 anchor, Vec2, const Numbers &one, Directions)
    {
        const SpringPull s = spring(mover, anchor, one.k);
        return {{"d", s.d}, {"pull", s.pull}};
    }
};

extern template class PairForce<BodyLaw>;

class BodySpring : public Described<PairForce<BodyLaw>, described::body_spring>
{
public:
    /// k in 1/frame^2.
    BodySpring(const std::vector<Link> &links, double k) : Described({}, pairsOf(links), {{k}}) {}
};

}
