#pragma once

#include "sim/effects/springs/radial_spring.h"

namespace sim {

namespace descriptions {
extern const EffectDescription springs;
}

/// A spring between two points. Both points feel it.
struct Spring
{
    int a = 0;
    int b = 0;
    double k = 0.0;      ///< mass/frame^2
    double length = 0.0; ///< px, rest length
    friend bool operator==(const Spring &, const Spring &) = default;
};

/// Springs with individual stiffnesses and lengths: radial springs that pull both ends.
class Springs : public DescribedEffect<PairForce<RadialLaw>, descriptions::springs>
{
public:
    /// @throws Error "spring-without-end" (spring, end, points) if a spring ends at a point that does not
    /// exist
    Springs(const std::vector<Spring> &springs, int points);
};

}
