#include "sim/methods/implicit/newton.h"

#include "sim/methods/implicit/solvers/linear_solve.h"
#include "sim/methods/implicit/solvers/semidefinite.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr int mostHalvings = 6;

/// Whether a change of velocities changes the places that they lead to by no more than this share of them.
bool isWithin(double share, const Numbers &change, double reach, const Numbers &place)
{
    return (reach * change.abs() <= share * (1.0 + place.abs())).all();
}

/// Whether a correction is so small that the next one is lost in rounding.
bool isTiny(const Numbers &step, double reach, const Numbers &place)
{
    return isWithin(1e-12, step, reach, place);
}

/// Whether a correction is far below what can be seen, though it is not lost in rounding.
bool isClose(const Numbers &step, double reach, const Numbers &place)
{
    return isWithin(1e-9, step, reach, place);
}

/// Whether corrections are so small that pulls are straight lines along them, and shrink no more: then they correct
/// how a stiff spring's pull is rounded.
bool isNoise(const Numbers &next, const Numbers &step, double reach, const Numbers &place)
{
    return next.abs().maxCoeff() >= step.abs().maxCoeff() && isWithin(1e-6, next, reach, place);
}

}

Equations::Equations(const Scene &scene, DirectionRule directionRule)
    : m_system(scene, directionRule), m_points(scene.start.pointCount())
{
    const bool turns = scene.start.spin.rows() > 0; // then places follow from angles
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

/// What solve() wants: u = drift + share a(from + reach u).
struct ImplicitStep::Wanted
{
    const Numbers &from;
    const Numbers &drift;
    double reach;
    const Numbers &share;
};

ImplicitStep::ImplicitStep(const Equations &equations, State &state, JacobianKind effort)
    : motion{Numbers(equations.flow().size()), Numbers(equations.flow().size())}, m_equations(equations),
      m_state(state), m_effort(effort), m_unknowns(equations.unknowns(state))
{
    equations.flow().readState(state, motion.x.data(), motion.v.data());
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] < 0)
            motion.v[static_cast<Eigen::Index>(row)] = 0.0;
        else
            ++m_count;
    }
}

Numbers ImplicitStep::pulls(const Numbers &place)
{
    Numbers a(place.size());
    m_equations.flow().writePositions(place.data(), m_state);
    m_equations.flow().accelerations(m_state, a.data());
    m_state.pointEvaluations += m_state.pointCount();
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] < 0)
            a[static_cast<Eigen::Index>(row)] = 0.0;
    }
    return a;
}

/// The velocity that leads to where the state is.
Numbers ImplicitStep::standing(const Wanted &wanted) const
{
    UnknownMotion now = motion;
    m_equations.flow().readState(m_state, now.x.data(), now.v.data());
    Numbers u = Numbers::Zero(now.x.size());
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        const auto i = static_cast<Eigen::Index>(row);
        if (m_unknowns[row] >= 0)
            u[i] = (now.x[i] - wanted.from[i]) / wanted.reach;
    }
    return u;
}

/// By how much `u` misses what is wanted.
Numbers ImplicitStep::misses(const Wanted &wanted, const Numbers &u)
{
    return u - wanted.drift - wanted.share * pulls(wanted.from + wanted.reach * u);
}

/// How fast what u misses changes with u, where the state is: with 1 on the diagonal, the entries of that matrix.
std::vector<Jacobian::Entry> ImplicitStep::changes(const Wanted &wanted, Kept kept) const
{
    Jacobian jacobian(m_state.pointCount());
    m_equations.flow().jacobian(m_state, jacobian);
    const std::vector<Jacobian::Entry> calm =
        kept == Kept::calm ? nearestNegativeSemidefiniteBlocks(jacobian, m_state.pointCount())
                           : std::vector<Jacobian::Entry>();
    const std::vector<Jacobian::Entry> &given = kept == Kept::calm ? calm : jacobian.entries();
    std::vector<Jacobian::Entry> entries;
    entries.reserve(given.size());
    for (const Jacobian::Entry &entry : given) {
        const int row = m_unknowns[static_cast<std::size_t>(entry.row)];
        const int column = m_unknowns[static_cast<std::size_t>(entry.column)];
        if (row >= 0 && column >= 0)
            entries.push_back({row, column, -wanted.share[entry.row] * wanted.reach * entry.value});
    }
    return entries;
}

/// What to take off u for what it misses, if that changes by `entries`.
Numbers ImplicitStep::stepFor(const Numbers &wrong, const Numbers &share,
                              const std::vector<Jacobian::Entry> &entries) const
{
    const int points = m_state.pointCount();
    Eigen::VectorXd right(m_count), weights(m_count);
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        const auto i = static_cast<Eigen::Index>(row);
        if (m_unknowns[row] < 0)
            continue;
        right[m_unknowns[row]] = wrong[i];
        weights[m_unknowns[row]] = 1.0 / (share[i] * m_state.inverseMass[i % points]);
    }
    const Eigen::VectorXd found = solved(entries, right, weights);
    Numbers step = Numbers::Zero(wrong.size());
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] >= 0)
            step[static_cast<Eigen::Index>(row)] = found[m_unknowns[row]];
    }
    return step;
}

/// What to take off u to make good what it misses, if pulls change with places by their slopes at u.
Numbers ImplicitStep::correction(const Wanted &wanted, const Numbers &u)
{
    const Numbers wrong = misses(wanted, u);
    if (isWithin(1e-15, wrong, wanted.reach, wanted.from))
        return Numbers::Zero(u.size()); // rounding: not worth a matrix
    return stepFor(wrong, wanted.share, changes(wanted, Kept::all));
}

/// Where Newton's method has found nothing, or jumps about: the same without the slopes that push (see
/// nearestNegativeSemidefiniteBlocks()), so that no step leads away. It takes more steps, as what turns then comes round a part of the way at a time. Returns
/// what misses least of all this and `plain`; see lost() where every way from the start leads out of the finite numbers.
Numbers ImplicitStep::calmly(const Wanted &wanted, const Numbers &start, const Numbers &plain)
{
    Numbers best = plain, u = start;
    double least = misses(wanted, plain).abs().maxCoeff();
    Numbers last = Numbers::Constant(u.size(), std::numeric_limits<double>::infinity());
    bool metNoNumber = false;
    for (int i = 0; i < m_effort.projected; ++i) {
        const Numbers wrong = misses(wanted, u);
        const double most = wrong.abs().maxCoeff();
        if (std::isfinite(most) && !(most >= least)) { // also where nothing was finite so far
            least = most;
            best = u;
        }
        const Numbers step = stepFor(wrong, wanted.share, changes(wanted, Kept::calm));
        metNoNumber = metNoNumber || !std::isfinite(most) || !step.isFinite().all();
        if (!step.isFinite().all() || isTiny(step, wanted.reach, wanted.from) ||
            isNoise(step, last, wanted.reach, wanted.from))
            break;
        u = u - step;
        last = step;
    }
    const bool standsStill = (best == start).all();
    return !std::isfinite(least) || (standsStill && metNoNumber) ? lost(wanted, start) : best;
}

/// Says that nothing is found, in place of letting all stand still: `start` without the numbers whose pulls are not
/// finite there, or without any, where all are.
Numbers ImplicitStep::lost(const Wanted &wanted, const Numbers &start)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Array<bool, Eigen::Dynamic, 1> found = misses(wanted, start).isFinite();
    if (found.all())
        return Numbers::Constant(start.size(), none);
    return found.select(start, none);
}

/// Takes `step` off u; or a half, a quarter... of it, if the whole leads to where nothing is finite. Returns the next
/// correction; NaN, and u as it was, if there is no way from here. That the next one is smaller is not asked for: to turn with a stiff
/// spring, Newton's method first leaves it by a hair's breadth, which looks far worse than it is, and then comes back;
/// steps that never may get worse creep along it instead.
Numbers ImplicitStep::advance(const Wanted &wanted, Numbers &u, const Numbers &step)
{
    double part = 1.0;
    for (int halvings = 0; halvings <= mostHalvings; ++halvings, part *= 0.5) {
        const Numbers to = u - part * step;
        Numbers next = correction(wanted, to);
        if (next.isFinite().all()) {
            u = to;
            return next;
        }
    }
    return Numbers::Constant(u.size(), std::numeric_limits<double>::quiet_NaN());
}

Numbers ImplicitStep::solve(const Numbers &from, const Numbers &drift, double reach, const Numbers &share)
{
    const Wanted wanted{from, drift, reach, share};
    const int plain = m_effort.exact;
    // Shown lines are short.
    // clang-format off
    //! [newton]
    // wanted: u = drift + share a(...)
    // at first, as if nothing moved
    const Numbers start = standing(wanted);
    Numbers u = start;
    // as if pulls grew evenly from here
    Numbers step = correction(wanted, u);
    for (int i = 0; i < plain; ++i) {
        if (isTiny(step, reach, from))
            return u - step;
        Numbers next =
            advance(wanted, u, step);
        if (!next.isFinite().all())
            break; // no way on from here
        if (isNoise(next, step, reach, from))
            return u;
        step = next;
    }
    if (isClose(step, reach, from))
        return u;
    // it jumps about, or is lost: calmer
    return calmly(wanted, start, u);
    //! [newton]
    // clang-format on
}

void ImplicitStep::finish()
{
    m_equations.flow().writePositions(motion.x.data(), m_state);
    m_equations.flow().writeVelocities(motion.v.data(), m_state);
}

}
