#pragma once

#include "sim/effects/effect_description.h"
#include "sim/effects/tree/tree.h"

namespace sim {

namespace descriptions {
extern const EffectDescription torsion;
}

/// The moment of inertia and the joint stiffness of each branch of a tree.
struct BranchMechanics
{
    Eigen::ArrayXd inertia;   ///< of the branch and all branches it carries; 1 for a trunk alone
    Eigen::ArrayXd stiffness; ///< inertia/frame^2, torsional stiffness of the joint at its origin
};

/// Returns the moment of inertia of a branch about its origin. The unit is the inertia of the trunk alone.
/// Length and thickness are proportional to `scale`, so the mass is proportional to scale^3 and the inertia
/// of the rod, m L^2 / 3, to scale^5. The branches that it carries have the mass `carried`, in masses of the
/// trunk. They count as a point mass at the end of the branch: m L^2, three times the inertia of a rod.
/// Source: the diagonal of the mass matrix of a chain of rods in absolute angles (Goldstein, "Classical
/// mechanics", section 1.6). The other entries are ignored, so the inertia does not depend on the angles.
// Shown lines are short.
// clang-format off
inline
//! [branch_inertia]
double branchInertia(
    double scale, double carried)
{
    double rod = std::pow(scale, 5);
    double load =
        3 * carried * scale * scale;
    double inertia = rod + load;
    return inertia;
}
//! [branch_inertia]
// clang-format on

/// Returns the torsional stiffness of a branch's joint. It grows with the inertia that the joint has to turn.
/// A thinner branch swings faster: if nothing else moves, the square of its angular frequency is k / scale.
/// `k` in 1/frame^2: a stiffness per inertia.
// Shown lines are short.
// clang-format off
inline
//! [branch_stiffness]
double branchStiffness(
    double k, double inertia,
    double scale)
{
    double stiffness =
        k * inertia / scale;
    return stiffness;
}
//! [branch_stiffness]
// clang-format on

/// Returns the inertia and the stiffness of each branch of `tree`. `k`: see branchStiffness().
BranchMechanics branchMechanicsOf(const Tree &tree, double k);

/// Returns the torque of a joint on its branch by Hooke's law, in inertia * degrees/frame^2. A bend is the
/// angle by which a branch is turned from its rest angle, in degrees. The parent feels the opposite torque.
// Shown lines are short.
// clang-format off
inline
//! [torsion]
double torsion(
    double bend, double parentBend,
    double stiffness)
{
    double twist = bend - parentBend;
    double torque = -stiffness * twist;
    return torque;
}
//! [torsion]
// clang-format on

/// Returns the angular acceleration of a branch (degrees/frame^2). `torque` acts at its origin. `reaction` is
/// the sum of the torques on its children; their reactions act at its end.
// Shown lines are short.
// clang-format off
inline
//! [turned_by]
double turnedBy(
    double torque, double reaction,
    double inertia)
{
    // to each action a reaction
    double pull =
        (torque - reaction) / inertia;
    return pull;
}
//! [turned_by]
// clang-format on

/// Torsion springs: one in the joint between each branch and its parent, and one between trunk and ground.
/// The energy is the sum of a function of the spins and a function of the angles. So with semi-implicit Euler
/// it stays bounded as long as h < 2 / sqrt(e), where e is the largest eigenvalue of stiffness/inertia.
/// stiffnessBound() is an upper bound of e.
class Torsion : public DescribedEffect<Torque, descriptions::torsion>
{
public:
    Torsion(TreePtr tree, BranchMechanics mechanics)
        : m_tree(std::move(tree)), m_mechanics(std::move(mechanics))
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &couplings) const override { m_tree->addCouplings(couplings); }
    bool isIdle() const override { return (m_mechanics.stiffness == 0.0).all(); }
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override;
    bool addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const override;
    std::optional<double> potentialEnergy(const State &state) const override { return springEnergy(state); }
    Eigen::ArrayXd inertia() const override { return m_mechanics.inertia; }
    std::vector<LiveValue> explain(const State &state, int mover) const override;

    const BranchMechanics &mechanics() const { return m_mechanics; }
    /// Returns the kinetic energy of the spins, in inertia * (degrees/frame)^2.
    double kineticEnergy(const State &state) const;
    /// Returns the potential energy of the bent joints, in the same unit.
    double springEnergy(const State &state) const;
    /// Returns an upper bound of the largest eigenvalue of stiffness/inertia, in 1/frame^2.
    /// Source: Gershgorin's circle theorem.
    double stiffnessBound() const;

private:
    /// Returns the angle (degrees) by which `branch` is turned from its rest angle.
    double bend(const State &state, int branch) const;
    /// Returns the torque of the joint at the origin of `branch`.
    double torqueOn(const State &state, int branch) const;
    /// Returns the sum of the torques on the children of `branch`.
    double reactionOn(const State &state, int branch) const;

    TreePtr m_tree;
    BranchMechanics m_mechanics;
};

}
