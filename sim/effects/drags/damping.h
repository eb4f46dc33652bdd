#pragma once

#include "sim/effects/effect_description.h"

#include <limits>

namespace sim {

namespace described {
extern const Description damping;
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
class Damping : public Described<Drag, described::damping>
{
public:
    /// `damp` from 0 (stops at once) to 1 (no drag), per frame.
    explicit Damping(double damp);
    /// The same for some points only.
    Damping(double damp, Points only);

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::tied; }
    bool idle() const override { return m_damp == 1.0; }
    void slow(State &state, Points points, double h) const override;
    std::optional<double> keep(Points points, double h) const override;
    std::optional<double> rate(int point) const override;
    bool takeInto(Taken &into) const override;
    std::vector<Live> explain(const State &before, const State &after, int point, double h) const override;
    /// The factor that a velocity keeps over `h` frames.
    double keep(double h) const;

private:
    Points shareOf(Points points) const;

    double m_damp;
    double m_keepInOne; ///< keep(1): most steps are one frame, and a power takes longer than all the rest
    Points m_only = {0, std::numeric_limits<int>::max()};
};

/// The same for points that turn: what it shows is what it does to a spin.
class SpinDamping : public Damping
{
public:
    using Damping::Damping;
    std::vector<Region> regions(Directions directions) const override;
};

}
