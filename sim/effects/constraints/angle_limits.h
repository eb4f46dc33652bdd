#pragma once

#include "sim/effects/effect_description.h"

namespace sim {

namespace descriptions {
extern const EffectDescription angle_limits;
}

/// The range in which a joint may bend. The angle at `joint` is measured from the limb that ends at `a` to
/// the limb that ends at `b`, clockwise on the screen, from 0 to 360 degrees.
struct AngleLimit
{
    int a = 0;
    int joint = 0;
    int b = 0;
    double least = 0.0;  ///< degrees, minimum
    double most = 360.0; ///< degrees, maximum
};

/// Returns the angle from `a` to `b` round the origin, in degrees from 0 to 360. It is 0 if `a` or `b` is the
/// origin.
// Shown lines are short.
// clang-format off
inline
//! [angle_between]
double angleBetween(Vec2 a, Vec2 b)
{
    double across = a.x * b.y - a.y * b.x;
    double along = a.x * b.x + a.y * b.y;
    double rad = atan2(across, along);
    double angle = rad * 57.29577951308232;
    return angle < 0 ? angle + 360 : angle;
}
//! [angle_between]
// clang-format on

/// Returns `limb` rotated by `angle` degrees, clockwise on the screen.
// Shown lines are short.
// clang-format off
inline
//! [turned]
Vec2 rotated(Vec2 limb, double angle)
{
    double rad = angle / 57.29577951308232;
    double c = cos(rad), s = sin(rad);
    return {c * limb.x - s * limb.y,
            s * limb.x + c * limb.y};
}
//! [turned]
// clang-format on

/// Returns by how many degrees `angle` is past the nearer of its limits: positive past `most`, negative past
/// `least`.
// Shown lines are short.
// clang-format off
inline
//! [past_limit]
double pastLimit(
    double angle, double least, double most)
{
    if (angle >= least && angle <= most)
        return 0;
    double over = angle - most;
    double under = least - angle;
    if (over < 0) over += 360; // full turn
    if (under < 0) under += 360;
    return over < under ? over : -under;
}
//! [past_limit]
// clang-format on

/// Three points after a joint was bent back, with the intermediate values.
struct JointEnds
{
    Vec2 a;
    Vec2 joint;
    Vec2 b;
    double angle = 0.0; ///< degrees, before the correction
    double past = 0.0;  ///< degrees, see pastLimit()
};

/// Rotates both limbs of a joint, each by half of the angle past the limit. The centroid of the three points
/// stays where it is, so the correction turns the joint but does not push it.
// Shown lines are short.
// clang-format off
inline
//! [angle_limit]
JointEnds bendBack(
    Vec2 a, Vec2 joint, Vec2 b,
    double least, double most)
{
    Vec2 to_a = a - joint;
    Vec2 to_b = b - joint;
    double angle = angleBetween(to_a, to_b);
    double past =
        pastLimit(angle, least, most);
    if (past != 0) {
        Vec2 new_a = rotated(to_a, past / 2);
        Vec2 new_b = rotated(to_b, -past / 2);
        Vec2 moved = new_a - to_a + new_b - to_b;
        joint = joint - (1.0 / 3) * moved;
        a = joint + new_a;
        b = joint + new_b;
    }
    return {a, joint, b, angle, past};
}
//! [angle_limit]
// clang-format on

/// Limits for the angles of joints. A limit acts only while it is exceeded.
class AngleLimits : public DescribedEffect<Constraint, descriptions::angle_limits>
{
public:
    explicit AngleLimits(std::vector<AngleLimit> limits) : m_limits(std::move(limits)) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    /// Enforces each limit whose highest point index is in `points`. Moves only dynamic points.
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    std::vector<AngleLimit> m_limits;
};

}
