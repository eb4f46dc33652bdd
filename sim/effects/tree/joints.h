#pragma once

#include "sim/effects/effect_description.h"
#include "sim/effects/tree/tree.h"

namespace sim {

namespace descriptions {
extern const EffectDescription joints;
}

/// Moves each branch of a tree to the end of its parent. Published: swaying tree, positionChildren().
class Joints : public DescribedEffect<Driver, descriptions::joints>
{
public:
    /// `degrees`: number of degrees per radian, see degreesOf().
    Joints(TreePtr tree, double degrees) : m_tree(std::move(tree)), m_degrees(degrees) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &couplings) const override { m_tree->addCouplings(couplings); }
    /// Also sets the spin of branches that are not dynamic to 0.
    void drive(State &state, double h) const override;
    DriverTiming timing() const override { return DriverTiming::dependent; }
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

    const Tree &tree() const { return *m_tree; }
    /// Returns the number of degrees per radian.
    double degrees() const { return m_degrees; }

private:
    TreePtr m_tree;
    double m_degrees;
};

}
