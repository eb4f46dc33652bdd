#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"
#include "sim/effects/pairs/spring.h"

namespace sim {

namespace descriptions {
extern const EffectDescription motor;
extern const EffectDescription anticipation;
}

/// Returns the pull of a spring from point `x` to the target. The tutorial has another unit of time: a frame
/// is `dt` units, so its `k` is k dt^2 in mass/frame^2.
/// Published: Codeling, driving the motion.
// Shown lines are short.
// clang-format off
inline
//! [motor]
SpringPull motor(
    Vec2 x, Vec2 target,
    double k, double dt)
{
    double k_frame = k * dt * dt;
    return spring(x, target, k_frame);
}
//! [motor]
// clang-format on

/// The spring that pulls a swimmer to the target.
class Motor : public DescribedEffect<Force, descriptions::motor>, public InputReader
{
public:
    /// `k` in mass/unit^2, `dt` in units per frame, where unit is the tutorial's unit of time.
    Motor(int mover, double k, double dt) : m_mover(mover), m_k(k), m_dt(dt) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind kind) const override { return kind == InputKind::target; }
    bool isIdle() const override { return m_k * m_dt * m_dt == 0.0; }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override;
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override;

private:
    int m_mover;
    double m_k;
    double m_dt;
};

/// The motion of a point after a shift away from the target.
struct Shifted
{
    Vec2 x;     ///< px
    Vec2 v;     ///< px/frame
    Vec2 shift; ///< px
};

/// Returns the motion of a point after it shifted away from a new target by the fraction `anticipation` of
/// its distance. The tutorial computes velocities from changes of position, so the shift changes the velocity
/// too. Published: Codeling, anticipation.
// Shown lines are short.
// clang-format off
inline
//! [anticipation]
Shifted anticipate(
    Vec2 x, Vec2 v, Vec2 target,
    double anticipation)
{
    Vec2 shift = anticipation * (x - target);
    x = x + shift;
    v = v + shift;
    return {x, v, shift};
}
//! [anticipation]
// clang-format on

/// Shifts a point away from each new target before it goes there. List it before all other effects, so that
/// it runs at the start of a step.
class Anticipation : public DescribedEffect<Driver, descriptions::anticipation>, public InputReader
{
public:
    /// `anticipation`: the shift of the point `mover` as a fraction of its distance to the target.
    Anticipation(int mover, double anticipation) : m_mover(mover), m_anticipation(anticipation) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind kind) const override { return kind == InputKind::target; }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    int m_mover;
    double m_anticipation;
};

}
