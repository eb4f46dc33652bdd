#pragma once

#include "sim/effects/reaction.h"
#include "sim/resting.h"

#include <cmath>
#include <vector>

namespace sim {

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

using std::cos;
using std::sin;

/// Where a foot belongs: `leg` px from the body, against the direction `angle` (rad).
/// Published: Creatures II, step 4.
// Shown lines are short.
// clang-format off
inline
//! [bone_target]
Vec2 boneTarget(
    Vec2 body, double angle, double leg)
{
    Vec2 bone = {leg * cos(angle),
                 leg * sin(angle)};
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

/// Springs that pull each foot to its own place, wherever it is.
class LegSpring : public Force, public Resting
{
public:
    LegSpring(std::vector<Leg> legs, LegRule rule);

    std::string id() const override { return "leg_spring"; }
    std::string title() const override { return SIM_TEXT("legs"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return m_rule.aim == Aim::swing ? Sees::scene : Sees::tied; }
    void ties(std::vector<Tie> &into) const override;
    bool idle() const override { return m_rule.k == 0.0; }
    /// A leg belongs to its foot: with Reaction::equal its body is pulled when the foot is among `movers`.
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    void addPart(const State &state, Points part, double scale, Directions directions,
                 Eigen::ArrayX2d &into) const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::optional<double> energy(const State &state) const override;
    bool balances(const State &state) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;
    void rests(const State &state, std::vector<RestEnd> &into) const override;

    /// Where the foot of the leg numbered `number` belongs, px.
    Vec2 target(const State &state, int number) const;
    /// Ordered by foot.
    const std::vector<Leg> &legs() const { return m_legs; }
    const LegRule &rule() const { return m_rule; }

private:
    template <class Visit>
    void forEach(const State &state, Points feet, Visit &&visit) const;
    Vec2 targetOf(const State &state, const Leg &leg) const;
    Vec2 pull(const State &state, const Leg &leg) const;
    void addLeg(const State &state, const Leg &leg, double scale, Eigen::ArrayX2d &into) const;
    bool bodyFeels(const State &state, const Leg &leg) const
    {
        return m_rule.reaction == Reaction::equal && state.feels(leg.body);
    }
    std::vector<Live> explainFoot(const State &state, const Leg &leg) const;

    std::vector<Leg> m_legs;   ///< by foot
    std::vector<Leg> m_byLast; ///< the same by the higher of their two points
    LegRule m_rule;
};

}
