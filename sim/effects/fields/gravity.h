#pragma once

#include "sim/effects/effect_description.h"

namespace sim {

namespace described {
extern const Description gravity;
}

/// The same pull straight down on every point, whatever its mass.
class Gravity : public Described<Force, described::gravity>
{
public:
    /// `gravity` in px/frame^2.
    explicit Gravity(double gravity) : m_gravity(gravity) {}

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::tied; }
    bool idle() const override { return m_gravity == 0.0; }
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    std::optional<double> fall() const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::optional<double> energy(const State &state) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;
    bool takeInto(Taken &into) const override;

    double gravity() const { return m_gravity; }

private:
    double m_gravity;
};

}
