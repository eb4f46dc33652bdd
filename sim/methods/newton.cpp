#include "sim/methods/newton.h"

#include <Eigen/Dense>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

/// Up to here a matrix with all its zeros is solved faster than one without.
constexpr int mostDense = 24;
constexpr int mostHalvings = 10;

Numbers solveDense(const std::vector<Slopes::Entry> &entries, const Eigen::VectorXd &right)
{
    using Small =
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostDense, mostDense>;
    Small matrix = Small::Identity(right.size(), right.size());
    for (const Slopes::Entry &entry : entries)
        matrix(entry.row, entry.column) += entry.value;
    return matrix.partialPivLu().solve(right).array();
}

/// Zeros where there is no solution.
Numbers solveSparse(const std::vector<Slopes::Entry> &entries, const Eigen::VectorXd &right)
{
    const Eigen::Index size = right.size();
    std::vector<Eigen::Triplet<double>> all;
    all.reserve(entries.size() + static_cast<std::size_t>(size));
    for (int i = 0; i < static_cast<int>(size); ++i)
        all.emplace_back(i, i, 1.0);
    for (const Slopes::Entry &entry : entries)
        all.emplace_back(entry.row, entry.column, entry.value);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(all.begin(), all.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
    if (factors.info() != Eigen::Success)
        return Numbers::Zero(size);
    return Eigen::VectorXd(factors.solve(right)).array();
}

double largest(const Numbers &numbers)
{
    return numbers.size() == 0 ? 0.0 : numbers.abs().maxCoeff<Eigen::PropagateNaN>();
}

/// Whether a correction of velocities is lost in the digits of the places that they lead to.
bool isTiny(const Numbers &step, double reach, const Numbers &place)
{
    return (reach * step.abs() <= 1e-12 * (1.0 + place.abs())).all();
}

}

Equations::Equations(const Scene &scene, Directions directions)
    : m_flow(scene, directions), m_points(scene.start.points())
{
    const bool turns = scene.start.spin.rows() > 0; // then places follow from angles
    for (const Flow::Stretch &stretch : m_flow.stretches()) {
        for (int row = stretch.first; row < stretch.end(); ++row)
            m_movable.push_back(std::isfinite(stretch.rate) && scene.hasInertia(row % m_points) &&
                                (!turns || row >= 2 * m_points));
    }
}

Numbers Equations::kept(double h) const
{
    Numbers keep(m_flow.size());
    for (const Flow::Stretch &stretch : m_flow.stretches())
        keep.segment(stretch.first, stretch.count) = std::exp(-stretch.rate * h);
    return keep;
}

std::vector<int> Equations::unknowns(const State &state) const
{
    std::vector<int> numbers(m_movable.size(), -1);
    int next = 0;
    for (int row = 0; row < m_flow.size(); ++row) {
        const auto at = static_cast<std::size_t>(row);
        if (m_movable[at] && state.feels(row % m_points))
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

ImplicitStep::ImplicitStep(const Equations &equations, State &state)
    : motion{Numbers(equations.flow().size()), Numbers(equations.flow().size())}, m_equations(equations),
      m_state(state), m_unknowns(equations.unknowns(state))
{
    equations.flow().read(state, motion.x.data(), motion.v.data());
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
    m_equations.flow().place(place.data(), m_state);
    m_equations.flow().accelerations(m_state, a.data());
    ++m_state.evaluations;
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] < 0)
            a[static_cast<Eigen::Index>(row)] = 0.0;
    }
    return a;
}

/// By how much `u` misses what is wanted.
Numbers ImplicitStep::misses(const Wanted &wanted, const Numbers &u)
{
    return u - wanted.drift - wanted.share * pulls(wanted.from + wanted.reach * u);
}

/// The change of u that makes good what is wrong, if pulls change with places by their slopes where the state is.
Numbers ImplicitStep::correction(const Wanted &wanted, const Numbers &wrong) const
{
    Slopes slopes(m_state.points());
    m_equations.flow().slopes(m_state, slopes);
    std::vector<Slopes::Entry> entries;
    entries.reserve(slopes.entries().size());
    for (const Slopes::Entry &entry : slopes.entries()) {
        const int row = m_unknowns[static_cast<std::size_t>(entry.row)];
        const int column = m_unknowns[static_cast<std::size_t>(entry.column)];
        if (row >= 0 && column >= 0)
            entries.push_back({row, column, -wanted.share[entry.row] * wanted.reach * entry.value});
    }
    Eigen::VectorXd right(m_count);
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] >= 0)
            right[m_unknowns[row]] = wrong[static_cast<Eigen::Index>(row)];
    }
    const Numbers found = m_count <= mostDense ? solveDense(entries, right) : solveSparse(entries, right);
    Numbers step = Numbers::Zero(wrong.size());
    for (std::size_t row = 0; row < m_unknowns.size(); ++row) {
        if (m_unknowns[row] >= 0)
            step[static_cast<Eigen::Index>(row)] = found[m_unknowns[row]];
    }
    return step;
}

/// Takes `step` from u, or a half, a quarter... of it, so that less is wrong than before. Returns what part of it;
/// 0 if none would do.
double ImplicitStep::halvedUntilBetter(const Wanted &wanted, Numbers &u, Numbers &wrong, const Numbers &step)
{
    const double before = largest(wrong);
    double part = 1.0;
    for (int halvings = 0; halvings <= mostHalvings; ++halvings, part *= 0.5) {
        const Numbers shorter = u - part * step;
        const Numbers now = misses(wanted, shorter);
        if (largest(now) < before) {
            u = shorter;
            wrong = now;
            return part;
        }
    }
    return 0.0;
}

Numbers ImplicitStep::solve(const Numbers &from, const Numbers &drift, double reach, const Numbers &share)
{
    const Wanted wanted{from, drift, reach, share};
    // Shown lines are short.
    // clang-format off
    //! [newton]
    // wanted: u = drift + share a(...)
    Numbers u = drift;
    Numbers wrong = misses(wanted, u);
    for (int i = 0; i < 20; ++i) {
        // as if pulls grew evenly
        Numbers step =
            correction(wanted, wrong);
        if (isTiny(step, reach, from))
            return u - step;
        // too far? half of it, ...
        if (halvedUntilBetter(
                wanted, u, wrong, step) == 0)
            break;
    }
    return u;
    //! [newton]
    // clang-format on
}

void ImplicitStep::finish()
{
    m_equations.flow().place(motion.x.data(), m_state);
    m_equations.flow().push(motion.v.data(), m_state);
}

}
