#include "sim/methods/implicit/newton.h"

#include "sim/methods/implicit/solvers/linear_solve.h"
#include "sim/methods/implicit/solvers/semidefinite.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr int maxHalvings = 6;

/// Returns whether a change of velocities changes the positions by at most `share` of their size (plus 1).
bool isWithin(double share, const Numbers &change, double reach, const Numbers &x)
{
    return (reach * change.abs() <= share * (1.0 + x.abs())).all();
}

/// Returns whether a correction is so small that the next one would be lost in rounding.
bool isTiny(const Numbers &step, double reach, const Numbers &x)
{
    return isWithin(1e-12, step, reach, x);
}

/// Returns whether a correction is far below what is visible, though not lost in rounding.
bool isClose(const Numbers &step, double reach, const Numbers &x)
{
    return isWithin(1e-9, step, reach, x);
}

/// Returns whether corrections no longer shrink although forces are linear over such small distances. Then
/// they only follow the rounding errors of stiff springs.
bool isNoise(const Numbers &next, const Numbers &step, double reach, const Numbers &x)
{
    return next.abs().maxCoeff() >= step.abs().maxCoeff() && isWithin(1e-6, next, reach, x);
}

}

Equations::Equations(const Scene &scene, DirectionRule directionRule)
    : m_system(scene, directionRule), m_points(scene.start.pointCount())
{
    const bool turns = scene.start.spin.rows() > 0; // then positions follow from angles
    for (const OdeSystem::RateRange &range : m_system.rateRanges()) {
        for (int row = range.first; row < range.end(); ++row)
            m_movable.push_back(std::isfinite(range.rate) && scene.movesByVelocity(row % m_points) &&
                                (!turns || row >= 2 * m_points));
    }
}

Numbers Equations::kept(double h) const
{
    Numbers keep(m_system.size());
    for (const OdeSystem::RateRange &range : m_system.rateRanges())
        keep.segment(range.first, range.count) = std::exp(-range.rate * h);
    return keep;
}

std::vector<int> Equations::unknowns(const State &state) const
{
    std::vector<int> numbers(m_movable.size(), -1);
    int next = 0;
    for (int row = 0; row < m_system.size(); ++row) {
        const auto at = static_cast<std::size_t>(row);
        if (m_movable[at] && state.isDynamic(row % m_points))
            numbers[at] = next++;
    }
    return numbers;
}

/// The equation that solve() solves: u = drift + share a(from + reach u).
struct ImplicitStep::VelocityEquation
{
    const Numbers &from;
    const Numbers &drift;
    double reach;
    const Numbers &share;
};

ImplicitStep::ImplicitStep(const Equations &equations, State &state, CorrectionLimits limits)
    : motion{Numbers(equations.system().size()), Numbers(equations.system().size())}, m_equations(equations),
      m_state(state), m_limits(limits), m_unknowns(equations.unknowns(state))
{
    equations.system().readState(state, motion.x.data(), motion.v.data());
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] < 0)
            motion.v[static_cast<Eigen::Index>(row)] = 0.0;
        else
            ++m_count;
    }
}

Numbers ImplicitStep::accelerations(const Numbers &x, const Numbers &v)
{
    Numbers a(x.size());
    m_equations.system().writePositions(x.data(), m_state);
    if (m_equations.system().readsVelocities())
        m_equations.system().writeVelocities(v.data(), m_state);
    m_equations.system().accelerations(m_state, a.data());
    m_state.pointEvaluations += m_state.pointCount();
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] < 0)
            a[static_cast<Eigen::Index>(row)] = 0.0;
    }
    return a;
}

/// Returns the velocity that leads from `equation.from` to the positions of the state.
Numbers ImplicitStep::initialVelocity(const VelocityEquation &equation) const
{
    UnknownMotion now = motion;
    m_equations.system().readState(m_state, now.x.data(), now.v.data());
    Numbers u = Numbers::Zero(now.x.size());
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        const auto i = static_cast<Eigen::Index>(row);
        if (m_unknowns[row] >= 0)
            u[i] = (now.x[i] - equation.from[i]) / equation.reach;
    }
    return u;
}

/// Returns the residual of `u`. Moves the state to the positions that belong to `u`.
Numbers ImplicitStep::residualOf(const VelocityEquation &equation, const Numbers &u)
{
    return u - equation.drift - equation.share * accelerations(equation.from + equation.reach * u, u);
}

/// Returns the derivatives of the residual by u at the positions of the state, without the 1 on the diagonal.
std::vector<Jacobian::Entry> ImplicitStep::residualDerivatives(const VelocityEquation &equation,
                                                               Projection projection) const
{
    Jacobian jacobian(m_state.pointCount());
    m_equations.system().jacobian(m_state, jacobian);
    const bool isProjected = projection == Projection::semidefinite;
    const std::vector<Jacobian::Entry> projected =
        isProjected ? nearestNegativeSemidefiniteBlocks(jacobian, m_state.pointCount())
                    : std::vector<Jacobian::Entry>();
    const std::vector<Jacobian::Entry> &used = isProjected ? projected : jacobian.entries();
    std::vector<Jacobian::Entry> entries;
    entries.reserve(used.size());
    for (const Jacobian::Entry &entry : used) {
        const int row = m_unknowns[static_cast<std::size_t>(entry.row)];
        const int column = m_unknowns[static_cast<std::size_t>(entry.column)];
        if (row >= 0 && column >= 0)
            entries.push_back({row, column, -equation.share[entry.row] * equation.reach * entry.value});
    }
    return entries;
}

/// Returns the change to subtract from u for a residual with the derivatives `entries`.
Numbers ImplicitStep::correctionOf(const Numbers &residual, const Numbers &share,
                                   const std::vector<Jacobian::Entry> &entries) const
{
    const int points = m_state.pointCount();
    Eigen::VectorXd right(m_count), weights(m_count);
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        const auto i = static_cast<Eigen::Index>(row);
        if (m_unknowns[row] < 0)
            continue;
        right[m_unknowns[row]] = residual[i];
        weights[m_unknowns[row]] = 1.0 / (share[i] * m_state.inverseMass[i % points]);
    }
    const Eigen::VectorXd found = solved(entries, right, weights);
    Numbers step = Numbers::Zero(residual.size());
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] >= 0)
            step[static_cast<Eigen::Index>(row)] = found[m_unknowns[row]];
    }
    return step;
}

/// Returns the change that Newton's method subtracts from `u`, with the Jacobian at `u`.
Numbers ImplicitStep::correction(const VelocityEquation &equation, const Numbers &u)
{
    const Numbers residual = residualOf(equation, u);
    if (isWithin(1e-15, residual, equation.reach, equation.from))
        return Numbers::Zero(u.size()); // only rounding: not worth a matrix
    return correctionOf(residual, equation.share, residualDerivatives(equation, Projection::none));
}

/// Continues with the projected Jacobian (see nearestNegativeSemidefiniteBlocks()) after Newton's method did
/// not converge. These corrections do not diverge, but rotations take more of them. Returns the candidate
/// with the smallest residual, including `plain`, the result of Newton's method. If no candidate is usable,
/// returns failedSolution().
Numbers ImplicitStep::solveProjected(const VelocityEquation &equation, const Numbers &start,
                                     const Numbers &plain)
{
    Numbers best = plain, u = start;
    double smallest = residualOf(equation, plain).abs().maxCoeff();
    Numbers previousStep = Numbers::Constant(u.size(), std::numeric_limits<double>::infinity());
    bool metNonFinite = false;
    for (int i = 0; i < m_limits.projected; ++i) {
        const Numbers residual = residualOf(equation, u);
        const double largest = residual.abs().maxCoeff();
        if (std::isfinite(largest) && !(largest >= smallest)) { // true also if `smallest` is NaN
            smallest = largest;
            best = u;
        }
        const Numbers step =
            correctionOf(residual, equation.share, residualDerivatives(equation, Projection::semidefinite));
        metNonFinite = metNonFinite || !std::isfinite(largest) || !step.isFinite().all();
        if (!step.isFinite().all() || isTiny(step, equation.reach, equation.from) ||
            isNoise(step, previousStep, equation.reach, equation.from))
            break;
        u = u - step;
        previousStep = step;
    }
    const bool isStart = (best == start).all();
    return !std::isfinite(smallest) || (isStart && metNonFinite) ? failedSolution(equation, start) : best;
}

/// Returns the result of a failed solution: `start`, with NaN for the numbers whose residual is not finite
/// there, or for all numbers if every residual is finite. Without NaN, the scene would silently stand still.
Numbers ImplicitStep::failedSolution(const VelocityEquation &equation, const Numbers &start)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Array<bool, Eigen::Dynamic, 1> areFinite = residualOf(equation, start).isFinite();
    if (areFinite.all())
        return Numbers::Constant(start.size(), nan);
    return areFinite.select(start, nan);
}

/// Subtracts `step` from `u`, or a half, a quarter and so on of it if the next correction is not finite.
/// Returns the next correction, or NaN with `u` unchanged if no part works. The next correction may be
/// larger. To turn a stiff spring, Newton's method first stretches it slightly, which gives a large residual,
/// and then corrects that. If the residual had to decrease in every step, the turn would take many tiny
/// steps.
Numbers ImplicitStep::advance(const VelocityEquation &equation, Numbers &u, const Numbers &step)
{
    double fraction = 1.0;
    for (int halvings = 0; halvings <= maxHalvings; ++halvings, fraction *= 0.5) {
        const Numbers candidate = u - fraction * step;
        Numbers next = correction(equation, candidate);
        if (next.isFinite().all()) {
            u = candidate;
            return next;
        }
    }
    return Numbers::Constant(u.size(), std::numeric_limits<double>::quiet_NaN());
}

Numbers ImplicitStep::solve(const Numbers &from, const Numbers &drift, double reach, const Numbers &share)
{
    const VelocityEquation equation{from, drift, reach, share};
    const int plain = m_limits.exact;
    // Shown lines are short.
    // clang-format off
    //! [newton]
    // solves u = drift + share a(...)
    // at first, as if nothing moved
    const Numbers start = initialVelocity(equation);
    Numbers u = start;
    // as if pulls were linear here
    Numbers step = correction(equation, u);
    for (int i = 0; i < plain; ++i) {
        if (isTiny(step, reach, from))
            return u - step;
        Numbers next =
            advance(equation, u, step);
        if (!next.isFinite().all())
            break; // no finite step
        if (isNoise(next, step, reach, from))
            return u;
        step = next;
    }
    if (isClose(step, reach, from))
        return u;
    // not converged: safer steps
    return solveProjected(equation, start, u);
    //! [newton]
    // clang-format on
}

void ImplicitStep::finish()
{
    m_equations.system().writePositions(motion.x.data(), m_state);
    m_equations.system().writeVelocities(motion.v.data(), m_state);
}

}
