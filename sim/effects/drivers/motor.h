#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"
#include "sim/effects/pairs/spring.h"

namespace sim {

namespace descriptions {
extern const EffectDescription motor;
extern const EffectDescription anticipation;
}

/// A spring from one point to the target. The tutorial counts time in units of its own: a frame is `dt` of them, so
/// its k acts as k dt^2 each frame.
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

class Motor : public DescribedEffect<Force, descriptions::motor>, public InputReader
{
public:
    /// k in 1 over the tutorial's unit of time squared, dt in those units per frame.
    Motor(int mover, double k, double dt) : m_mover(mover), m_k(k), m_dt(dt) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind signal) const override { return signal == InputKind::target; }
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

/// Where a shift away from the target leaves a point: farther off, and already on its way there.
struct Shifted
{
    Vec2 x;
    Vec2 v;
    Vec2 shift;
};

/// As the way that it came is the velocity of a point that remembers its place before, a shift is both.
/// Published: Codeling, anticipation.
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

/// Takes each new target in turn: before it goes there, `mover` is shifted the other way. List it first.
class Anticipation : public DescribedEffect<Driver, descriptions::anticipation>, public InputReader
{
public:
    /// `anticipation`: the part of the way to the target that it is shifted.
    Anticipation(int mover, double anticipation) : m_mover(mover), m_anticipation(anticipation) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind signal) const override { return signal == InputKind::target; }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    int m_mover;
    double m_anticipation;
};

}
