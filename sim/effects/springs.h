#pragma once

#include "sim/effects/radial_spring.h"

namespace sim {

/// A spring of its own between two points, both of which feel it.
struct Spring
{
    int a = 0;
    int b = 0;
    double k = 0.0;      ///< mass/frame^2
    double length = 0.0; ///< px, at which it neither pulls nor pushes
    friend bool operator==(const Spring &, const Spring &) = default;
};

/// Springs of which each has its own stiffness and its own length: radial springs that pull both ends.
class Springs : public RestingPairForce<RadialLaw>
{
public:
    /// @throws Error "spring-without-end" (spring, end, points) when a spring ends at a point that is not there
    Springs(std::vector<Spring> springs, int points);

    std::string id() const override { return "springs"; }
    std::string title() const override { return SIM_TEXT("springs"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions directions) const override
    {
        return RadialLaw::regions(directions);
    }
    bool idle() const override;

    const std::vector<Spring> &list() const { return m_springs; }

private:
    std::vector<Spring> m_springs;
};

}
