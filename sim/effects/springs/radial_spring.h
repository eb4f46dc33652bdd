#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/spring.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription radial_spring;
}

/// The published pull of a radial spring, with its intermediate values.
struct RadialPull
{
    Vec2 from;      ///< px, position of the mover seen from the anchor
    Vec2 target;    ///< px, position at rest length from the anchor
    SpringPull end; ///< spring of rest length 0 to that target
};

/// Computes a spring from `mover` to the nearest position that is `radius` px away from `anchor`.
/// `direction(d)` returns the direction of the vector `d`. k in mass/frame^2.
/// Published: Creatures I, step 7.
// Shown lines are short.
// clang-format off
template <class DirectionOf>
//! [radial_spring]
RadialPull radialSpring(
    Vec2 mover, Vec2 anchor, double k,
    double radius, DirectionOf direction)
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

/// Returns the same pull as radialSpring(), computed with one square root and one division. The pull on
/// the other end is exactly the opposite. k in mass/frame^2, radius in px. Not for coincident points; see
/// RadialLaw::pullWhenCoincident().
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

/// Springs that keep points at a distance from other points, in any direction.
struct RadialLaw
{
    struct Numbers
    {
        double k = 0.0;      ///< mass/frame^2
        double radius = 0.0; ///< px, rest length
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = true;

    static PairPull pull(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return springPull(mover, anchor, numbers.k, numbers.radius);
    }
    static Vec2 pullWhenCoincident(Vec2 out, const Numbers &numbers)
    {
        return numbers.k * numbers.radius * out;
    }
    static Vec2 published(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return radialSpring(mover, anchor, numbers.k, numbers.radius,
                            [](Vec2 d) { return publishedDirection(d).out; })
            .end.pull;
    }
    static PairJacobian jacobian(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return radialSpringJacobian(mover - anchor, numbers.k, numbers.radius);
    }
    static double energy(Vec2 mover, Vec2 anchor, const Numbers &numbers)
    {
        return springEnergy(length(mover - anchor) - numbers.radius, numbers.k);
    }
    static std::vector<LiveValue> liveValues(Vec2 mover, Vec2 anchor, Vec2 fallback, const Numbers &numbers,
                                             DirectionRule directionRule);
    static RestTarget restTarget(const State &state, const PointPair &link, const Numbers &numbers)
    {
        return restTargetAt(state, link.mover, link.anchor, numbers.radius);
    }
    static std::vector<Region> regions(DirectionRule directionRule);
    static bool isIdle(const Numbers &numbers) { return numbers.k == 0.0; }
    static double restLength(const Numbers &numbers) { return numbers.radius; }
};

extern template class PairForce<RadialLaw>;

/// Radial springs with equal numbers.
class RadialSpring : public DescribedEffect<PairForce<RadialLaw>, descriptions::radial_spring>
{
public:
    /// k in mass/frame^2, radius (the rest length) in px.
    RadialSpring(const std::vector<Link> &links, double k, double radius)
        : DescribedEffect({}, pairsOf(links), {{k, radius}})
    {
    }
};

}
