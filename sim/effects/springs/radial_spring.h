#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/spring.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription radial_spring;
}

/// A radial spring's pull as published, with what it was found from.
struct RadialPull
{
    Vec2 from;      ///< px, the anchor seen from which the mover lies along `heading`
    Vec2 target;    ///< px
    SpringPull end; ///< the plain spring to that target
};

/// A spring to the nearest place that is `radius` pixels away from `anchor`, in the direction in which `mover`
/// already is. `direction(d)` gives it. k in 1/frame^2.
/// Published: Creatures I, step 7.
// Shown lines are short.
// clang-format off
template <class HeadingOf>
//! [radial_spring]
RadialPull radialSpring(
    Vec2 mover, Vec2 anchor, double k,
    double radius, HeadingOf direction)
{
    Vec2 from = mover - anchor;
    Vec2 out = direction(from);
    Vec2 reach = radius * out;
    Vec2 target = anchor + reach;
    auto end = spring(mover, target, k);
    return {from, target, end};
}
//! [radial_spring]
// clang-format on

/// The same pull with one root and one division, and with the exact opposite for the other end. k in 1/frame^2, radius in
/// px. Points in one place have no direction: see fallbackDirection().
/// Source: k (radius out - from) with out = from / length; Published: Creatures I, step 7.
// Shown lines are short.
// clang-format off
inline
//! [spring_pull]
PairPull springPull(
    Vec2 mover, Vec2 anchor, double k,
    double radius)
{
    Vec2 from = mover - anchor;
    double square =
        from.x * from.x + from.y * from.y;
    double length = std::sqrt(square);
    // above 0: too short, it pushes
    double share = radius / length - 1;
    Vec2 pull = k * share * from;
    return {pull, length};
}
//! [spring_pull]
// clang-format on

/// Springs that keep points at a distance from other points, in whatever direction they are.
struct RadialLaw
{
    struct Numbers
    {
        double k = 0.0;      ///< 1/frame^2
        double radius = 0.0; ///< px, the length at which it neither pulls nor pushes
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = true;

    static PairPull pull(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return springPull(mover, anchor, one.k, one.radius);
    }
    static Vec2 pullWhenCoincident(Vec2 out, const Numbers &one) { return one.k * one.radius * out; }
    static Vec2 published(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return radialSpring(mover, anchor, one.k, one.radius,
                            [](Vec2 d) { return publishedDirection(d).out; })
            .end.pull;
    }
    static PairJacobian jacobian(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return radialSpringJacobian(mover - anchor, one.k, one.radius);
    }
    static double energy(Vec2 mover, Vec2 anchor, const Numbers &one)
    {
        return springEnergy(length(mover - anchor) - one.radius, one.k);
    }
    static std::vector<LiveValue> liveValues(Vec2 mover, Vec2 anchor, Vec2 parting, const Numbers &one,
                                             DirectionRule directionRule);
    static RestTarget rest(const State &state, const PointPair &link, const Numbers &one)
    {
        return restTargetAt(state, link.mover, link.anchor, one.radius);
    }
    static std::vector<Region> regions(DirectionRule directionRule);
    static bool isIdle(const Numbers &one) { return one.k == 0.0; }
    static double restLength(const Numbers &one) { return one.radius; }
};

extern template class PairForce<RadialLaw>;

/// Radial springs that are all alike.
class RadialSpring : public DescribedEffect<PairForce<RadialLaw>, descriptions::radial_spring>
{
public:
    /// k in 1/frame^2, radius (the rest length) in px.
    RadialSpring(const std::vector<Link> &links, double k, double radius)
        : DescribedEffect({}, pairsOf(links), {{k, radius}})
    {
    }
};

}
