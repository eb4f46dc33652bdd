#pragma once

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/reaction.h"
#include "sim/effects/pairs/spring.h"

#include <cmath>
#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription leg_spring;
}

/// A leg. It holds its foot at an angle, seen from the body.
struct Leg
{
    int foot = 0;
    int body = 0;
    double angle = 0.0; ///< rad; at 0 the foot is to the left of the body, at pi / 2 above it
    int clock = 0;      ///< index of the gait clock that turns it
};

/// The rule for the target position of a foot.
enum class Aim {
    bone,  ///< angle and length of the leg
    below, ///< also LegRule::drop
    swing, ///< also LegRule::drop and the angle of the gait clock
};

/// The numbers that all legs of a creature share.
struct LegRule
{
    double k = 0.0;    ///< mass/frame^2
    double leg = 0.0;  ///< px, length: distance from the centre of the circle of target positions to the foot
    double drop = 0.0; ///< px, how far that centre is below the body; 0 for Aim::bone, which ignores it
    Aim aim = Aim::bone;
    Reaction reaction = Reaction::none; ///< whether the body feels the opposite pull
};

/// Returns the target position of a foot: `leg` px from the body, against the direction `angle` (rad).
/// Published: Creatures II, step 4.
// Shown lines are short.
// clang-format off
inline
//! [bone_target]
Vec2 boneTarget(
    Vec2 body, double angle, double leg)
{
    Vec2 bone = {leg * std::cos(angle),
                 leg * std::sin(angle)};
    Vec2 target = body - bone;
    return target;
}
//! [bone_target]
// clang-format on

/// Returns the target position `drop` px farther down than boneTarget(). Published: Creatures II, step 6.
// Shown lines are short.
// clang-format off
inline
//! [below_target]
Vec2 belowTarget(
    Vec2 body, double angle, double leg,
    double drop)
{
    Vec2 target =
        boneTarget(body, angle, leg);
    target.y += drop;
    return target;
}
//! [below_target]
// clang-format on

/// Returns the angle (rad) of a leg after the gait clock has turned it by `gait` (rad). Published: Creatures
/// II, step 8.
//! [gait_angle]
inline double gaitAngle(double angle, double gait)
{
    double turned = angle + gait;
    return turned;
}
//! [gait_angle]

/// Springs that pull each foot to its target position. The foot is the mover, the body the anchor.
struct LegLaw : LegRule
{
    struct Numbers
    {
        double angle = 0.0; ///< rad
        int clock = 0;
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = false;

    /// Returns `numbers` with the angle to which the gait clock has turned the leg.
    Numbers currentNumbers(const State &state, const Numbers &numbers) const
    {
        return {aim == Aim::swing ? gaitAngle(numbers.angle, state.gait[numbers.clock]) : numbers.angle,
                numbers.clock};
    }
    Vec2 target(Vec2 body, const Numbers &numbers) const
    {
        return aim == Aim::bone ? boneTarget(body, numbers.angle, leg)
                                : belowTarget(body, numbers.angle, leg, drop);
    }
    PairPull pull(Vec2 foot, Vec2 body, const Numbers &numbers) const
    {
        return {published(foot, body, numbers)};
    }
    static Vec2 pullWhenCoincident(Vec2, const Numbers &) { return {}; }
    Vec2 published(Vec2 foot, Vec2 body, const Numbers &numbers) const
    {
        return spring(foot, target(body, numbers), k).pull;
    }
    PairJacobian jacobian(Vec2, Vec2, const Numbers &) const { return pointSpringJacobian(k); }
    /// When the gait clock turns a leg, it changes the stored energy. That change is work done by the clock.
    double energy(Vec2 foot, Vec2 body, const Numbers &numbers) const
    {
        return springEnergy(length(target(body, numbers) - foot), k);
    }
    std::vector<Region> regions(DirectionRule directionRule) const;
    bool isIdle(const Numbers &) const { return k == 0.0; }
    std::vector<LiveValue> liveValues(Vec2 foot, Vec2 body, Vec2 fallback, const Numbers &numbers,
                                      DirectionRule directionRule) const;
    RestTarget restTarget(const State &state, const PointPair &legPair, const Numbers &numbers) const
    {
        return {legPair.mover, legPair.anchor, target(state.positionOf(legPair.anchor), numbers), false};
    }
};

extern template class PairForce<LegLaw>;

class LegSpring : public DescribedEffect<PairForce<LegLaw>, descriptions::leg_spring>
{
public:
    LegSpring(const std::vector<Leg> &legs, LegRule rule);

    Dependence dependence() const override
    {
        return rule().aim == Aim::swing ? Dependence::scene : Dependence::coupledPoints;
    }
    bool addToDraft(BlueprintDraft &draft) const override;

    /// Returns the target position (px) of the foot of leg `index` in legs().
    Vec2 target(const State &state, int index) const;
    /// Returns the legs, sorted by foot.
    std::vector<Leg> legs() const;
    const LegRule &rule() const { return law(); }
};

}
