#include "sim/methods/implicit/solvers/linear_solve.h"

#include "sim/methods/implicit/solvers/conjugate_gradients.h"

#include <Eigen/Dense>
#include <Eigen/SparseLU>

#include <cmath>

namespace sim {

namespace {

/// Up to here a matrix with all its zeros is solved faster than one without.
constexpr int mostDense = 64;
/// From here on nets are solved by conjugate gradients.
constexpr int leastConjugate = 256;
/// A part of rounding: Newton's next correction makes good what is left.
constexpr double tolerance = 1e-12;

using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostDense, mostDense>;
using Sparse = Eigen::SparseMatrix<double>;

/// 1 on the diagonal, and entries that add up.
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

Eigen::VectorXd byFactors(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &right)
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
    if (size <= mostDense)
        return Solver::dense;
    if (size < leastConjugate || size % 2 != 0)
        return Solver::sparse;
    // A spring between two points that both move has 16 entries: four for each end, by either end.
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
            const Eigen::VectorXd weighted = inTurn(weights.cwiseProduct(right));
            const Conjugate found = conjugateGradients(*matrix, weighted, tolerance);
            if (found.x.allFinite())
                return inColumns(found.x);
        }
    }
    return byFactors(entries, right);
}

}
