#pragma once

#include "sim/effects/pair_force.h"
#include "sim/effects/spring.h"

namespace sim {

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

class BodySpring : public PairForce<BodyLaw>
{
public:
    /// k in 1/frame^2.
    BodySpring(const std::vector<Link> &links, double k) : PairForce({}, pairsOf(links), {{k}}) {}

    std::string id() const override { return "body_spring"; }
    std::string title() const override { return SIM_TEXT("spring"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions) const override { return {{"sim/effects/spring.h", "spring"}}; }
    bool idle() const override { return k() == 0.0; }

    std::vector<Link> links() const { return linksOf(pairs()); }
    double k() const { return numbers().front().k; }
};

}
