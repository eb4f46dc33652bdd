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

/// A leg that knows where its foot belongs: at an angle of its own, seen from the body.
struct Leg
{
    int foot = 0;
    int body = 0;
    double angle = 0.0; ///< rad; 0 is straight left of the body, a quarter turn straight above it
    int clock = 0;      ///< which gait clock turns it
};

/// What a foot's own place takes into account.
enum class Aim {
    bone,  ///< the leg's angle and length
    below, ///< and how far below the body the legs end
    swing, ///< and how far the gait clock has turned
};

/// What all legs of a creature have in common.
struct LegRule
{
    double k = 0.0;    ///< 1/frame^2
    double leg = 0.0;  ///< px, from the middle of all places of a foot to each
    double drop = 0.0; ///< px, how far that middle lies below the body; not for Aim::bone
    Aim aim = Aim::bone;
    Reaction reaction = Reaction::none; ///< what the body feels
};

/// Where a foot belongs: `leg` px from the body, against the direction `angle` (rad).
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

/// The same, `drop` px farther down. Published: Creatures II, step 6.
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

/// A leg's angle when the gait clock stands at `gait` (rad). Published: Creatures II, step 8.
//! [gait_angle]
inline double gaitAngle(double angle, double gait)
{
    double turned = angle + gait;
    return turned;
}
//! [gait_angle]

/// Springs that pull each foot to its own place, wherever it is. A foot is the mover, its body the anchor.
struct LegLaw : LegRule
{
    struct Numbers
    {
        double angle = 0.0; ///< rad
        int clock = 0;
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = false;

    /// With the angle to which the gait clock has turned the leg.
    Numbers now(const State &state, const Numbers &one) const
    {
        return {aim == Aim::swing ? gaitAngle(one.angle, state.gait[one.clock]) : one.angle, one.clock};
    }
    Vec2 target(Vec2 body, const Numbers &one) const
    {
        return aim == Aim::bone ? boneTarget(body, one.angle, leg) : belowTarget(body, one.angle, leg, drop);
    }
    PairPull pull(Vec2 foot, Vec2 body, const Numbers &one) const { return {published(foot, body, one)}; }
    static Vec2 pullWhenCoincident(Vec2, const Numbers &) { return {}; }
    Vec2 published(Vec2 foot, Vec2 body, const Numbers &one) const
    {
        return spring(foot, target(body, one), k).pull;
    }
    PairJacobian jacobian(Vec2, Vec2, const Numbers &) const { return pointSpringJacobian(k); }
    /// Where the clock turns a leg it lifts what the leg has stored, too: that is the clock's work.
    double energy(Vec2 foot, Vec2 body, const Numbers &one) const
    {
        return springEnergy(length(target(body, one) - foot), k);
    }
    std::vector<Region> regions(DirectionRule directionRule) const;
    bool isIdle(const Numbers &) const { return k == 0.0; }
    std::vector<LiveValue> liveValues(Vec2 foot, Vec2 body, Vec2 parting, const Numbers &one,
                                      DirectionRule directionRule) const;
    RestTarget rest(const State &state, const PointPair &legPair, const Numbers &one) const
    {
        return {legPair.mover, legPair.anchor, target(state.positionOf(legPair.anchor), one), false};
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

    /// Where the foot of the leg numbered `number` belongs, px.
    Vec2 target(const State &state, int number) const;
    /// Ordered by foot.
    std::vector<Leg> legs() const;
    const LegRule &rule() const { return law(); }
};

}
