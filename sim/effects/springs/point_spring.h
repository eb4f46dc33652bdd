#pragma once

#include "sim/effects/effect_description.h"

namespace sim {

namespace described {
extern const Description point_spring;
}

/// A spring from one point to a fixed place.
class PointSpring : public Described<Force, described::point_spring>
{
public:
    /// k in 1/frame^2, centre in px.
    PointSpring(int mover, Vec2 centre, double k) : m_mover(mover), m_centre(centre), m_k(k) {}

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::tied; }
    bool idle() const override { return m_k == 0.0; }
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::optional<double> energy(const State &state) const override;
    bool takeInto(Taken &into) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;

    int mover() const { return m_mover; }
    Vec2 centre() const { return m_centre; }

private:
    int m_mover;
    Vec2 m_centre;
    double m_k;
};

}
