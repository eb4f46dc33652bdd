#pragma once

#include "sim/methods/ode_system.h"

#include <vector>

namespace sim {

using Numbers = Eigen::ArrayXd;

/// The equations q'' = a(q, t) - c q' of a scene, and the numbers of q that an implicit method solves for
/// (the unknowns). A point is unknown if it moves by its velocity and damping does not stop it at once (c is
/// finite).
class Equations
{
public:
    Equations(const Scene &scene, DirectionRule directionRule);

    const OdeSystem &system() const { return m_system; }
    /// Returns the damping factor of each number of q over `h` frames: e^(-c h), or 0 if c is infinite.
    Numbers kept(double h) const;
    /// Returns the index among the unknowns of each number of q, or -1.
    std::vector<int> unknowns(const State &state) const;

private:
    OdeSystem m_system;
    int m_points;
    std::vector<char> m_movable; ///< per number of q, whether it is unknown unless its point is dragged
};

/// Positions (px, degrees) and velocities (per frame), in the order of OdeSystem.
struct UnknownMotion
{
    Numbers x;
    Numbers v;
};

/// The maximum numbers of corrections of a step before it fails.
struct CorrectionLimits
{
    int exact = 20; ///< corrections by Newton's method
    /// Further corrections with the projected Jacobian if Newton's method does not converge, see
    /// nearestNegativeSemidefiniteBlocks().
    int projected = 60;
};

/// One step of an implicit method.
class ImplicitStep
{
public:
    ImplicitStep(const Equations &equations, State &state, CorrectionLimits limits = {});

    UnknownMotion motion; ///< the current values, which the method advances

    /// Runs the continuous drivers for `h` frames.
    void tick(double h) { m_equations.system().advanceDrivers(m_state, h); }
    /// Returns the damping factor of each number over `h` frames.
    Numbers kept(double h) const { return m_equations.kept(h); }
    /// Returns the accelerations at the positions `x`, in px/frame^2 or degrees/frame^2; 0 for numbers
    /// that are not unknown.
    Numbers accelerations(const Numbers &x) { return accelerations(x, motion.v); }
    /// Returns the velocity u with u = drift + share a(from + reach u), by Newton's method. `reach` and
    /// `share` are in frames. The iteration starts at the positions of the state, because the nearest
    /// solution is the right one: in the others, springs have turned over within the step. It stops when
    /// corrections are below 1e-12 of the positions or lost in rounding. If it does not converge (for
    /// example, when a crowd bursts from one point and forces reverse), corrections with the projected
    /// Jacobian follow. Returns NaN if these find nothing finite, so the run ends here. Forces that depend on velocities
    /// are computed at u. The matrices leave their derivatives by velocity out, so more corrections may be necessary.
    /// Source: Hairer and Wanner, "Solving ordinary differential equations II", section IV.8.
    Numbers solve(const Numbers &from, const Numbers &drift, double reach, const Numbers &share);
    /// Does the same with `share` = `reach`.
    Numbers solve(const Numbers &from, const Numbers &drift, double reach)
    {
        return solve(from, drift, reach, Numbers::Constant(from.size(), reach));
    }
    /// Writes `motion` to the state.
    void finish();

private:
    struct VelocityEquation;
    /// The same for forces that depend on the velocities `v`.
    Numbers accelerations(const Numbers &x, const Numbers &v);
    Numbers initialVelocity(const VelocityEquation &equation) const;
    Numbers residualOf(const VelocityEquation &equation, const Numbers &u);
    Numbers correction(const VelocityEquation &equation, const Numbers &u);
    enum class Projection {
        none,         ///< the exact Jacobian
        semidefinite, ///< see nearestNegativeSemidefiniteBlocks()
    };
    std::vector<Jacobian::Entry> residualDerivatives(const VelocityEquation &equation,
                                                     Projection projection) const;
    Numbers correctionOf(const Numbers &residual, const Numbers &share,
                         const std::vector<Jacobian::Entry> &entries) const;
    Numbers solveProjected(const VelocityEquation &equation, const Numbers &start, const Numbers &plain);
    Numbers failedSolution(const VelocityEquation &equation, const Numbers &start);
    Numbers advance(const VelocityEquation &equation, Numbers &u, const Numbers &step);

    const Equations &m_equations;
    State &m_state;
    CorrectionLimits m_limits;
    std::vector<int> m_unknowns;
    int m_count = 0;
};

}
