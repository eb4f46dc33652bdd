#pragma once

#include "sim/effects/effect_description.h"
#include "sim/effects/tree/tree.h"

namespace sim {

namespace descriptions {
extern const EffectDescription torsion;
}

/// What each branch of a tree has to be turned by, and how stiff its joint is. One entry a branch.
struct BranchMechanics
{
    Eigen::ArrayXd inertia;   ///< rotary, of the branch and what it carries; a lone trunk has 1
    Eigen::ArrayXd stiffness; ///< of the joint at its origin: inertia/frame^2
};

/// The rotary inertia of a branch round its origin, in units of a lone trunk's. Length and thickness go with its
/// scale, so its mass goes with the cube, and a rod's inertia, m L^2 / 3, with the fifth power. What it carries,
/// with masses in units of the trunk's, sits at its end, a length away: m L^2, three times as much.
/// Source: these are the diagonal entries of the mass matrix of a chain of rods in absolute angles (Goldstein,
/// "Classical mechanics", section 1.6); the others are left out, so that the inertia stays what it is at rest.
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

/// The stiffness of a branch's joint. A branch grows as strong as what it carries needs; and the thinner it is,
/// the faster it swings: by itself with the square of its angular frequency k / scale. k in 1/frame^2.
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

/// Inertia and stiffness of each branch of `tree`.
BranchMechanics branchMechanicsOf(const Tree &tree, double k);

/// Hooke's law for a joint: the torque on the branch, in inertia * degrees/frame^2. A bend is how far a branch is
/// turned from its angle of rest, in degrees. The parent feels the opposite.
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

/// The angular acceleration of a branch: the torque at its origin, less those at its end, where its children bend.
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

/// Springs that turn: one in the joint of each branch with its parent, and of the trunk with the ground.
/// With the angle and spin of each branch as coordinates the energy is a sum of one part of the spins and one of
/// the angles, so semi-implicit Euler keeps it bounded as long as h < 2 / sqrt(the largest eigenvalue of
/// stiffness/inertia); stiffnessBound() bounds that eigenvalue.
class Torsion : public DescribedEffect<Torque, descriptions::torsion>
{
public:
    Torsion(TreePtr tree, BranchMechanics limbs) : m_tree(std::move(tree)), m_limbs(std::move(limbs)) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override { m_tree->addCouplings(into); }
    bool isIdle() const override { return (m_limbs.stiffness == 0.0).all(); }
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override;
    bool addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const override;
    std::optional<double> potentialEnergy(const State &state) const override { return springEnergy(state); }
    Eigen::ArrayXd inertia() const override { return m_limbs.inertia; }
    std::vector<LiveValue> explain(const State &state, int mover) const override;

    const BranchMechanics &mechanics() const { return m_limbs; }
    /// Of the spins, and of the bent joints: inertia * (degrees/frame)^2, where a lone trunk's inertia is 1.
    double kineticEnergy(const State &state) const;
    double springEnergy(const State &state) const;
    /// An upper bound of the largest eigenvalue, 1/frame^2: by Gershgorin's circles.
    double stiffnessBound() const;

private:
    double bend(const State &state, int branch) const;
    double torqueOn(const State &state, int branch) const;
    double reactionOn(const State &state, int branch) const;

    TreePtr m_tree;
    BranchMechanics m_limbs;
};

}
