#pragma once

#include "sim/effects/effect_description.h"

namespace sim {

namespace descriptions {
extern const EffectDescription gravity;
}

/// The same downward acceleration for every dynamic point, whatever its mass.
class Gravity : public DescribedEffect<Force, descriptions::gravity>
{
public:
    /// `gravity` in px/frame^2.
    explicit Gravity(double gravity) : m_gravity(gravity) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    bool isIdle() const override { return m_gravity == 0.0; }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    std::optional<double> uniformGravity() const override;
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override;
    std::optional<double> potentialEnergy(const State &state) const override;
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    double gravity() const { return m_gravity; }

private:
    double m_gravity;
};

}
