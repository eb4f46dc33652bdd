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

/// What the wind does to a branch, with what it was found from.
struct WindPush
{
    double air = 0.0;  ///< degrees/frame^2
    double turn = 0.0; ///< the sine of the angle between the branch and the wind
    double pull = 0.0; ///< degrees/frame^2
};

/// The push of a wind of direction `out` (length 1) on a branch: hardest across it, none along it. For small angles
/// it turns a lone branch by wind / (distance scale) times the missing angle, as an acceleration; what the branch
/// carries slows it. That is the published law with one power of the scale less: so thin branches are pushed faster
/// in the measure in which they swing faster, and a step that suits their springs suits the wind. Nearer than 100 px
/// the wind is as strong as there. `share` is what gusts leave of it; `along` is the branch's direction.
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

/// Wind that pushes each branch away from the pointer, as a gust that runs outwards (see GustFront).
class WindTorque : public DescribedEffect<Torque, descriptions::wind>, public InputReader
{
public:
    /// `wind`: its strength; `gusts`: the share by which it swells and ebbs.
    WindTorque(TreePtr tree, Eigen::ArrayXd inertia, double wind, double gusts)
        : m_tree(std::move(tree)), m_inertia(std::move(inertia)), m_wind(wind), m_gusts(gusts)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind signal) const override { return signal == InputKind::pointer; }
    bool isIdle() const override { return m_wind == 0.0; }
    void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const override;
    /// A branch is pushed where it ends, so what it is pushed by depends on the angles of all branches below it, too:
    /// down to the trunk, or to one that a hand holds. The places of the origins follow from the angles (Joints).
    bool addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const override;
    Eigen::ArrayXd inertia() const override { return m_inertia; }
    std::vector<LiveValue> explain(const State &state, int mover) const override;

private:
    struct Found
    {
        double distance = 0.0;
        Vec2 out;
        double share = 0.0;
        WindPush push;
    };
    Found pushOn(const State &state, int branch) const;
    struct Change
    {
        Vec2 byEnd;
        double byTurning = 0.0;
    };
    Change changeOf(const State &state, int branch) const;

    TreePtr m_tree;
    Eigen::ArrayXd m_inertia;
    double m_wind;
    double m_gusts;
};

}
