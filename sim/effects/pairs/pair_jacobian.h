#pragma once

#include "sim/scene/effect.h"

namespace sim {

/// How a pull changes with the place of the point that it pulls: 1/frame^2.
struct PairJacobian
{
    double xx = 0.0;
    double xy = 0.0; ///< the pull along x, by y
    double yx = 0.0;
    double yy = 0.0;
    friend constexpr PairJacobian operator*(double s, PairJacobian a)
    {
        return {s * a.xx, s * a.xy, s * a.yx, s * a.yy};
    }
};

/// Of a spring to a place: the pull shrinks by k each pixel that the point comes nearer, whatever the direction.
constexpr PairJacobian pointSpringJacobian(double k)
{
    return {-k, 0.0, 0.0, -k};
}

/// Of a spring that keeps a point at `distance` px from where `from` (px) points away from. Along the spring the
/// pull changes by -k; across it, it turns with the spring: k (distance / length - 1). Points in one place have no
/// across: there it is -k in all directions.
/// Source: the derivative of k (distance from/|from| - from); Baraff and Witkin, "Large steps in cloth simulation",
/// 1998, section 4.
inline PairJacobian radialSpringJacobian(Vec2 from, double k, double distance)
{
    const double far = length(from);
    if (far < 1e-150)
        return pointSpringJacobian(k);
    const Vec2 out = {from.x / far, from.y / far};
    const double turns = k * distance / far;
    const double xy = -turns * out.x * out.y;
    return {turns * out.y * out.y - k, xy, xy, turns * out.x * out.x - k};
}

inline void addJacobianBlock(Jacobian &jacobian, int mover, int by, PairJacobian block)
{
    jacobian.add(mover, by, block.xx, block.xy, block.yx, block.yy);
}

/// Of a pull that depends on nothing but where `mover` is from `anchor`.
inline void addPairJacobian(Jacobian &jacobian, int mover, int anchor, PairJacobian block)
{
    addJacobianBlock(jacobian, mover, mover, block);
    addJacobianBlock(jacobian, mover, anchor, -1.0 * block);
}

}
