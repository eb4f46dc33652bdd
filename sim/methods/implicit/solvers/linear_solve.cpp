#include "sim/methods/implicit/solvers/linear_solve.h"

#include "sim/methods/implicit/solvers/conjugate_gradients.h"

#include <Eigen/Dense>
#include <Eigen/SparseLU>

#include <cmath>

namespace sim {

namespace {

/// Up to this size, the dense solver is faster than the sparse one.
constexpr int maxDense = 64;
/// From this size on, conjugate gradients solve nets.
constexpr int minConjugate = 256;
/// The relative residual of conjugate gradients. The next correction of Newton's method removes the rest.
constexpr double tolerance = 1e-12;

using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, maxDense, maxDense>;
using Sparse = Eigen::SparseMatrix<double>;

/// Returns 1 + entries. Entries at the same position add up.
Small denseOf(const std::vector<Jacobian::Entry> &entries, int size)
{
    Small matrix = Small::Identity(size, size);
    for (const Jacobian::Entry &entry : entries)
        matrix(entry.row, entry.column) += entry.value;
    return matrix;
}

Sparse sparseOf(const std::vector<Jacobian::Entry> &entries, int size)
{
    std::vector<Eigen::Triplet<double>> all;
    all.reserve(entries.size() + static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i)
        all.emplace_back(i, i, 1.0);
    for (const Jacobian::Entry &entry : entries)
        all.emplace_back(entry.row, entry.column, entry.value);
    Sparse matrix(size, size);
    matrix.setFromTriplets(all.begin(), all.end());
    return matrix;
}

Eigen::VectorXd solveSparse(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &right)
{
    const auto size = static_cast<int>(right.size());
    const Eigen::SparseLU<Sparse> factors(sparseOf(entries, size));
    if (factors.info() != Eigen::Success)
        return Eigen::VectorXd::Constant(size, std::nan(""));
    return factors.solve(right);
}

}

Solver solverFor(const std::vector<Jacobian::Entry> &entries, int size)
{
    if (size <= maxDense)
        return Solver::dense;
    if (size < minConjugate || size % 2 != 0)
        return Solver::sparse;
    // A spring between two points that can both move has 16 entries: 2 x 2 for each pair of ends.
    const std::size_t springs = entries.size() / 16, points = static_cast<std::size_t>(size / 2);
    return springs > points + points / 2 ? Solver::conjugate : Solver::sparse;
}

Eigen::VectorXd solved(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &right,
                       const Eigen::VectorXd &weights)
{
    const auto size = static_cast<int>(right.size());
    const Solver solver = solverFor(entries, size);
    if (solver == Solver::dense)
        return denseOf(entries, size).partialPivLu().solve(right);
    if (solver == Solver::conjugate) {
        if (const auto matrix = SpringMatrix::of(entries, weights)) {
            const Eigen::VectorXd weighted = interleaved(weights.cwiseProduct(right));
            const ConjugateResult found = conjugateGradients(*matrix, weighted, tolerance);
            if (found.x.allFinite())
                return separated(found.x);
        }
    }
    return solveSparse(entries, right);
}

}
