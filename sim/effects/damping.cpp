#include "sim/effects/damping.h"

namespace sim {

namespace {

/// The factor that a velocity keeps over h frames.
//! [damping]
double kept(double damp, double h)
{
    double keep = std::pow(damp, h);
    return keep;
}
//! [damping]

}

std::vector<Region> Damping::regions(Directions) const
{
    return {{"sim/effects/damping.cpp", "damping"}};
}

int Damping::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

double Damping::keep(double h) const
{
    return kept(m_damp, h);
}

}
