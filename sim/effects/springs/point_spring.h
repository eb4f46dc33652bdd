#pragma once

#include "sim/effects/effect_description.h"

namespace sim {

namespace descriptions {
extern const EffectDescription point_spring;
}

/// A spring from one point to a fixed position.
class PointSpring : public DescribedEffect<Force, descriptions::point_spring>
{
public:
    /// k in mass/frame^2, centre in px.
    PointSpring(int mover, Vec2 centre, double k) : m_mover(mover), m_centre(centre), m_k(k) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    bool isIdle() const override { return m_k == 0.0; }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override;
    std::optional<double> potentialEnergy(const State &state) const override;
    bool addToDraft(BlueprintDraft &draft) const override;
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override;

    int mover() const { return m_mover; }
    Vec2 centre() const { return m_centre; }

private:
    int m_mover;
    Vec2 m_centre;
    double m_k;
};

}
