#pragma once

#include "sim/effects/effect_description.h"

#include <limits>

namespace sim {

namespace descriptions {
extern const EffectDescription damping;
}

/// What damping leaves of a velocity, and of a spin.
// The marker leaves out what learners need not read.
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

/// Drag that lets every velocity keep the share `damp` each frame: the continuous model v' = -c v with
/// c = -ln(damp) per frame, taken exactly: over h frames a velocity keeps damp^h.
class Damping : public DescribedEffect<Drag, descriptions::damping>
{
public:
    /// `damp` from 0 (stops at once) to 1 (no drag), per frame.
    explicit Damping(double damp);
    /// The same for some points only.
    Damping(double damp, PointRange only);

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
    /// The factor that a velocity keeps over `h` frames.
    double velocityFactor(double h) const;

private:
    PointRange shareOf(PointRange points) const;

    double m_damp;
    double m_keepInOne; ///< keep(1): most steps are one frame, and a power takes longer than all the rest
    PointRange m_only = {0, std::numeric_limits<int>::max()};
};

/// The same for points that turn: what it shows is what it does to a spin.
class SpinDamping : public Damping
{
public:
    using Damping::Damping;
    std::vector<Region> regions(DirectionRule directionRule) const override;
};

}
