#pragma once

#include "sim/methods/ode_system.h"

#include <vector>

namespace sim {

using Numbers = Eigen::ArrayXd;

/// A scene's equations q'' = a(q, t) - c q', and which of their numbers an implicit method solves for: those of
/// what goes on by itself and is not stopped at once (c infinite).
class Equations
{
public:
    Equations(const Scene &scene, DirectionRule directionRule);

    const OdeSystem &flow() const { return m_system; }
    /// What damping leaves of each velocity over `h` frames: e^(-c h), 0 where it stops at once.
    Numbers kept(double h) const;
    /// For each number of q its number among the unknowns, or -1.
    std::vector<int> unknowns(const State &state) const;

private:
    OdeSystem m_system;
    int m_points;
    std::vector<char> m_movable; ///< a number of q each
};

/// Places (px, degrees) and velocities, in the order of Flow.
struct UnknownMotion
{
    Numbers x;
    Numbers v;
};

/// How often a step is corrected before it is given up: bounds, as nothing else bounds them.
struct JacobianKind
{
    int exact = 20;     ///< corrections by Newton's method
    int projected = 60; ///< then, if those lead nowhere, corrections that leave out what pushes
};

/// One step of an implicit method under way.
class ImplicitStep
{
public:
    ImplicitStep(const Equations &equations, State &state, JacobianKind effort = {});

    UnknownMotion motion;

    /// Takes time on by `h` frames.
    void tick(double h) { m_equations.flow().advanceDrivers(m_state, h); }
    /// What damping leaves of each velocity over `h` frames.
    Numbers kept(double h) const { return m_equations.kept(h); }
    /// All pulls where things are at `place`: px/frame^2, degrees/frame^2.
    Numbers pulls(const Numbers &place);
    /// The velocity u that agrees with the pulls where it leads to, by Newton's method:
    /// u = drift + share a(from + reach u). Reach and share in frames. Starts from where the state is, as the nearest
    /// solution is the right one: beyond it are those in which springs swing through between two places. Stops when
    /// corrections are below 1e-12 of the places or lost in rounding. Where Newton's method finds none (as where a
    /// crowd bursts out of one place, and pulls turn round), it is looked for more calmly. NaN where nothing finite is
    /// found that way either: then the run ends there, and says so.
    /// Source: Hairer and Wanner, "Solving ordinary differential equations II", section IV.8.
    Numbers solve(const Numbers &from, const Numbers &drift, double reach, const Numbers &share);
    Numbers solve(const Numbers &from, const Numbers &drift, double reach)
    {
        return solve(from, drift, reach, Numbers::Constant(from.size(), reach));
    }
    /// Puts the motion into the state.
    void finish();

private:
    struct Wanted;
    Numbers standing(const Wanted &wanted) const;
    Numbers misses(const Wanted &wanted, const Numbers &u);
    Numbers correction(const Wanted &wanted, const Numbers &u);
    enum class Kept {
        all,  ///< slopes as they are
        calm, ///< those that push left out
    };
    std::vector<Jacobian::Entry> changes(const Wanted &wanted, Kept kept) const;
    Numbers stepFor(const Numbers &wrong, const Numbers &share,
                    const std::vector<Jacobian::Entry> &entries) const;
    Numbers calmly(const Wanted &wanted, const Numbers &start, const Numbers &plain);
    Numbers lost(const Wanted &wanted, const Numbers &start);
    Numbers advance(const Wanted &wanted, Numbers &u, const Numbers &step);

    const Equations &m_equations;
    State &m_state;
    JacobianKind m_effort;
    std::vector<int> m_unknowns;
    int m_count = 0;
};

}
