#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/reaction.h"
#include "sim/effects/pairs/spring.h"

#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription push;
}

/// The push between two points, with its intermediate values.
struct PushPull
{
    Vec2 from;            ///< px, position of `one` seen from `other`
    double missing = 0.0; ///< px, how much closer they are than `distance`; 0 or less: no push
    Vec2 pull;            ///< mass px/frame^2, on `one`
};

/// Computes a spring that only pushes. It pushes `one` away from `other` while they are closer than
/// `distance` px. `direction(d)` returns the length and the direction of the vector `d`. k in mass/frame^2.
/// Source: the penalty method; Moore and Wilhelms, "Collision detection and response for computer animation",
/// 1988.
// Shown lines are short.
// clang-format off
template <class DirectionOf>
//! [push]
PushPull push(
    Vec2 one, Vec2 other, double k,
    double distance, DirectionOf direction)
{
    Vec2 from = one - other;
    auto [far, out] = direction(from);
    double missing = distance - far;
    Vec2 pull = {0, 0};
    if (missing > 0)
        pull = k * missing * out;
    return {from, missing, pull};
}
//! [push]
// clang-format on

/// Pushes between points that are closer than `distance`.
struct PushLaw
{
    double k = 0.0;        ///< mass/frame^2
    double distance = 0.0; ///< px

    struct Numbers
    {
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = true;

    PairPull pull(Vec2 one, Vec2 other, const Numbers &) const
    {
        Direction heading;
        const Vec2 pull = push(one, other, k, distance, [&](Vec2 d) { return heading = direction(d); }).pull;
        return {pull, heading.length};
    }
    Vec2 pullWhenCoincident(Vec2 out, const Numbers &) const { return k * distance * out; }
    Vec2 published(Vec2 one, Vec2 other, const Numbers &) const
    {
        return push(one, other, k, distance, publishedDistanceAndDirection).pull;
    }
    PairJacobian jacobian(Vec2 one, Vec2 other, const Numbers &) const
    {
        const Vec2 from = one - other;
        return length(from) < distance ? radialSpringJacobian(from, k, distance) : PairJacobian();
    }
    double energy(Vec2 one, Vec2 other, const Numbers &) const
    {
        return springEnergy(std::max(0.0, distance - length(one - other)), k);
    }
    static std::vector<Region> regions(DirectionRule directionRule);
    bool isIdle(const Numbers &) const { return k == 0.0 || distance <= 0.0; }
    /// Returns the direction by the published rule, with the length of `d`.
    static Direction publishedDistanceAndDirection(Vec2 d) { return {length(d), publishedDirection(d).out}; }
    std::vector<LiveValue> liveValues(Vec2 one, Vec2 other, Vec2 fallback, const Numbers &,
                                      DirectionRule directionRule) const;
};

extern template class PairForce<PushLaw>;

/// Pushes any two of some points apart while they are too close to each other.
class Push : public DescribedEffect<PairForce<PushLaw>, descriptions::push>
{
public:
    /// k in mass/frame^2, distance in px. With Reaction::none, only the point with the lower index of each
    /// pair is pushed.
    Push(const std::vector<int> &points, double k, double distance, Reaction reaction);

    bool addToDraft(BlueprintDraft &draft) const override;
};

}
