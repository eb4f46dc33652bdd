#pragma once

#include "sim/effects/drivers/gust.h"
#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/tree.h"

#include <algorithm>

namespace sim {

namespace descriptions {
extern const EffectDescription wind;
}

/// The push of the wind on a branch, with its intermediate results.
struct WindPush
{
    double air = 0.0;  ///< degrees/frame^2, strength of the wind at the branch
    double turn = 0.0; ///< sine of the angle between the branch and the wind
    double pull = 0.0; ///< degrees/frame^2, angular acceleration of the branch
};

/// Returns the push of the wind on a branch. It is strongest if the wind blows across the branch and 0 if it
/// blows along it. For small angles, a branch that carries nothing is accelerated by wind / (distance scale)
/// times the angle to the wind. The published formula has scale^2 instead. With one power less, the push
/// on thinner branches grows at the same rate as their stiffness/inertia. So a step that is short enough for
/// the springs is short enough for the wind. Nearer than 100 px the wind is as strong as at 100 px.
/// `out`: direction of the wind, length 1. `along`: direction of the branch, length 1. `distance`: px.
/// `wind`: full strength of the wind. `share`: see gustAt(). `inertia`: see branchInertia().
// Shown lines are short.
// clang-format off
inline
//! [wind_push]
WindPush windPush(
    Vec2 out, Vec2 along, double distance,
    double wind, double share,
    double scale, double inertia)
{
    double far = std::max(distance, 100.0);
    double air = share * wind / far
        * degreesPerRadian;
    // the sine of the angle between
    double turn =
        along.x * out.y - along.y * out.x;
    double side = scale * scale;
    double torque =
        air * turn * side * side;
    // what it carries slows it
    double pull = torque / inertia;
    return {air, turn, pull};
}
//! [wind_push]
// clang-format on

/// Wind that pushes the branches away from the pointer, as a gust that runs outwards (see GustFront).
class WindTorque : public DescribedEffect<Torque, descriptions::wind>, public InputReader
{
public:
    /// `inertia`: of each branch, see BranchMechanics. `wind`: strength of the wind. `gusts`: see gustAt().
    WindTorque(TreePtr tree, Eigen::ArrayXd inertia, double wind, double gusts)
        : m_tree(std::move(tree)), m_inertia(std::move(inertia)), m_wind(wind), m_gusts(gusts)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind kind) const override { return kind == InputKind::pointer; }
    bool isIdle() const override { return m_wind == 0.0; }
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override;
    /// The push on a branch depends on the position of its end, so also on the angles of all branches below
    /// it: down to the trunk or to a dragged branch. The origins follow from these angles (see Joints).
    bool addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const override;
    Eigen::ArrayXd inertia() const override { return m_inertia; }
    std::vector<LiveValue> explain(const State &state, int mover) const override;

private:
    /// The push on a branch, with its arguments; see windPush().
    struct BranchPush
    {
        double distance = 0.0; ///< px, between the pointer and the branch's end
        Vec2 out;
        double share = 0.0;
        WindPush push;
    };
    BranchPush pushOn(const State &state, int branch) const;
    /// The derivatives of the push on a branch.
    struct PushDerivatives
    {
        Vec2 byEnd;           ///< degrees/frame^2 per px, by the position of its end
        double byAngle = 0.0; ///< 1/frame^2, by its angle if the end stays in place
    };
    /// Returns the derivatives of the push on `branch`. The push is a strength, which depends on the
    /// distance, times a sine.
    PushDerivatives pushDerivatives(const State &state, int branch) const;

    TreePtr m_tree;
    Eigen::ArrayXd m_inertia;
    double m_wind;
    double m_gusts;
};

}
