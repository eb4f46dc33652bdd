#include "sim/analysis/stability/modes/spectrum.h"

#include "sim/base/random.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sim {

namespace {

constexpr int maxRounds = 8;
/// Up to this size the solver gets the matrix itself: another basis would cost digits.
constexpr int maxDirectSize = 4;
constexpr double convergence = 1e-6;
/// Relative to the norm of the matrix, some tens of units in the last place.
constexpr double relativeRounding = 1e-14;
constexpr Eigen::Index restartVectors = 4; ///< eigenvectors that the next round starts from

/// Returns a pseudo-random vector, which has a component along every eigenvector.
Eigen::VectorXd startVector(int size)
{
    Eigen::VectorXd start(size);
    for (int i = 0; i < size; ++i)
        start[i] = uniform(1, 0, i) - 0.5;
    return start;
}

}

Spectrum::Spectrum(int size, const Product &product)
{
    if (size == 0)
        return;
    if (size <= maxDirectSize) {
        solveDense(size, product);
        return;
    }
    Vector start = startVector(size);
    for (int i = 0; i < maxRounds; ++i) {
        buildKrylovBasis(product, start);
        const double residual = m_residual * std::abs(m_smallVectors(m_smallVectors.rows() - 1, 0));
        if (size <= maxDenseSize || residual <= convergence * std::abs(m_values.front()))
            return;
        start.setZero();
        for (Eigen::Index k = 0; k < std::min(restartVectors, m_smallVectors.cols()); ++k) {
            const Eigen::VectorXcd vector = m_basis * m_smallVectors.col(k);
            start += vector.real() + vector.imag();
        }
    }
}

void Spectrum::solveDense(int size, const Product &product)
{
    m_basis = Eigen::MatrixXd::Identity(size, size);
    Eigen::MatrixXd matrix(size, size);
    Vector column(size);
    for (int i = 0; i < size; ++i) {
        product(m_basis.col(i), column);
        matrix.col(i) = column;
    }
    solveSmall(matrix);
}

void Spectrum::buildKrylovBasis(const Product &product, Vector start)
{
    const Eigen::Index size = start.size();
    const Eigen::Index maxColumns = std::min<Eigen::Index>(size, maxDenseSize);
    m_basis.resize(size, maxColumns);
    Eigen::MatrixXd small = Eigen::MatrixXd::Zero(maxColumns, maxColumns);
    m_basis.col(0) = start.normalized();
    Vector next(size);
    Eigen::Index columns = 1;
    for (;; ++columns) {
        product(m_basis.col(columns - 1), next);
        const double before = next.norm();
        // Orthogonalises twice, because rounding leaves components after the first pass.
        for (int pass = 0; pass < 2; ++pass) {
            const Vector projection = m_basis.leftCols(columns).transpose() * next;
            next -= m_basis.leftCols(columns) * projection;
            small.col(columns - 1).head(columns) += projection;
        }
        m_residual = next.norm();
        if (!(m_residual > 1e-13 * before)) // the basis is complete, or the product is not finite
            m_residual = 0.0;
        if (m_residual == 0.0 || columns == maxColumns)
            break;
        small(columns, columns - 1) = m_residual;
        m_basis.col(columns) = next / m_residual;
    }
    m_basis.conservativeResize(Eigen::NoChange, columns);
    solveSmall(small.topLeftCorner(columns, columns));
}

void Spectrum::solveSmall(const Eigen::MatrixXd &small)
{
    m_values.clear();
    if (!small.allFinite()) {
        m_values.push_back(INFINITY);
        m_smallVectors = Eigen::MatrixXcd::Identity(small.rows(), 1);
        return;
    }
    m_rounding = relativeRounding * small.norm();
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(small);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(small.rows()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto &values = solver.eigenvalues();
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return std::abs(values[a]) > std::abs(values[b]);
    });
    const Eigen::MatrixXcd vectors = solver.eigenvectors();
    m_smallVectors.resize(small.rows(), small.rows());
    for (std::size_t i = 0; i < order.size(); ++i) {
        m_values.push_back(values[order[i]]);
        m_smallVectors.col(static_cast<Eigen::Index>(i)) = vectors.col(order[i]);
    }
}

double Spectrum::radius() const
{
    return std::max(0.0, std::abs(m_values.front()) - m_rounding);
}

Eigen::VectorXcd Spectrum::vector(std::size_t index) const
{
    const Eigen::VectorXcd found = m_basis * m_smallVectors.col(static_cast<Eigen::Index>(index));
    const double length = found.norm();
    return length > 0.0 ? Eigen::VectorXcd(found / length) : found;
}

}
