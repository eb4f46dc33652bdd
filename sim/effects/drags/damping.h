#pragma once

#include "sim/effects/effect_description.h"

#include <limits>

namespace sim {

namespace descriptions {
extern const EffectDescription damping;
}

/// Return a velocity or a spin after damping. `keep`: the damping factor.
// The marker leaves out `inline`, which learners need not read.
// clang-format off
inline
//! [damp]
Vec2 damp(Vec2 v, double keep)
{
    v = keep * v;
    return v;
}
//! [damp]
inline
//! [damp_spin]
double dampSpin(double spin, double keep)
{
    spin = keep * spin;
    return spin;
}
//! [damp_spin]
// clang-format on

/// A drag that multiplies every velocity and spin by `damp` per frame. It is the exact solution of v' = -c v
/// with the damping rate c = -ln(damp) per frame, so the factor for h frames is damp^h.
class Damping : public DescribedEffect<Drag, descriptions::damping>
{
public:
    /// `damp` from 0 (stops at once) to 1 (no drag), per frame.
    explicit Damping(double damp);
    /// Damps only the points of `range`.
    Damping(double damp, PointRange range);

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    bool isIdle() const override { return m_damp == 1.0; }
    void apply(State &state, PointRange points, double h) const override;
    std::optional<double> velocityFactor(PointRange points, double h) const override;
    std::optional<double> dampingRate(int point) const override;
    bool addToDraft(BlueprintDraft &draft) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point,
                                   double h) const override;
    /// Returns the damping factor for `h` frames.
    double velocityFactor(double h) const;

private:
    /// Returns the part of `points` that this drag damps.
    PointRange dampedPart(PointRange points) const;

    double m_damp;
    /// The damping factor for one frame. Most steps last one frame, and std::pow would dominate their cost.
    double m_factorPerFrame;
    PointRange m_range = {0, std::numeric_limits<int>::max()};
};

/// The same drag, for scenes whose points rotate. Its shown code damps a spin.
class SpinDamping : public Damping
{
public:
    using Damping::Damping;
    std::vector<Region> regions(DirectionRule directionRule) const override;
};

}
