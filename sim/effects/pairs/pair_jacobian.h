#pragma once

#include "sim/base/direction.h"
#include "sim/scene/effect.h"

namespace sim {

/// The derivative of a pull by the position of a point, in mass/frame^2.
struct PairJacobian
{
    double xx = 0.0;
    double xy = 0.0; ///< derivative of the x component of the pull by y
    double yx = 0.0;
    double yy = 0.0;
    friend constexpr PairJacobian operator*(double s, PairJacobian a)
    {
        return {s * a.xx, s * a.xy, s * a.yx, s * a.yy};
    }
};

/// Returns the Jacobian of a spring of stiffness k (mass/frame^2) and rest length 0. It is the same in all
/// directions.
constexpr PairJacobian pointSpringJacobian(double k)
{
    return {-k, 0.0, 0.0, -k};
}

/// Returns the Jacobian of a spring with the rest length `distance` (px) and the stiffness k (mass/frame^2).
/// `from`: px, position of the mover seen from the anchor. The derivative is -k along the spring and k
/// (distance / length - 1) across it, because the pull turns with the spring. For coincident points it is -k
/// in all directions.
/// Source: the derivative of k (distance from/|from| - from); Baraff and Witkin, "Large steps in cloth
/// simulation", 1998, section 4.
inline PairJacobian radialSpringJacobian(Vec2 from, double k, double distance)
{
    const double far = length(from);
    if (far < coincidenceDistance)
        return pointSpringJacobian(k);
    const Vec2 out = {from.x / far, from.y / far};
    const double turns = k * distance / far;
    const double xy = -turns * out.x * out.y;
    return {turns * out.y * out.y - k, xy, xy, turns * out.x * out.x - k};
}

/// Adds `block`, the derivative of the acceleration of `mover` by the position of `by`.
inline void addJacobianBlock(Jacobian &jacobian, int mover, int by, PairJacobian block)
{
    jacobian.add(mover, by, block.xx, block.xy, block.yx, block.yy);
}

/// Adds the Jacobian of an acceleration of `mover` that depends only on its position relative to `anchor`.
/// `block`: the derivative by the position of `mover`.
inline void addPairJacobian(Jacobian &jacobian, int mover, int anchor, PairJacobian block)
{
    addJacobianBlock(jacobian, mover, mover, block);
    addJacobianBlock(jacobian, mover, anchor, -1.0 * block);
}

}
