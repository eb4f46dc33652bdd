#pragma once

#include "sim/effect.h"

#include <cmath>

namespace sim {

/// Drag that lets every velocity keep the share `damp` each frame: the continuous model v' = -c v with
/// c = -ln(damp) per frame, taken exactly: over h frames a velocity keeps damp^h.
class Damping : public Drag
{
public:
    /// `damp` from 0 (stops at once) to 1 (no drag), per frame.
    explicit Damping(double damp) : m_damp(damp) {}

    std::string id() const override { return "damping"; }
    std::string title() const override { return SIM_TEXT("damping"); }
    Kind kind() const override { return Kind::damping; }
    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    double keep(double h) const override;

private:
    double m_damp;
};

}
