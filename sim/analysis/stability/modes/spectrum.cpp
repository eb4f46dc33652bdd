#include "sim/analysis/stability/modes/spectrum.h"

#include "sim/base/random.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sim {

namespace {

constexpr int rounds = 8;
constexpr int tiny = 4; ///< up to this size matrices are taken as they are: a turned basis would cost digits
constexpr double settled = 1e-6;
constexpr double lastDigits = 1e-14; ///< of a matrix' norm: some tens of a double's last digits
constexpr Eigen::Index blended = 4;  ///< how many vectors the next round starts from

/// No direction is left out, and none is like another.
Eigen::VectorXd anyVector(int size)
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
    if (size <= tiny) {
        columnByColumn(size, product);
        return;
    }
    Vector start = anyVector(size);
    for (int i = 0; i < rounds; ++i) {
        round(product, start);
        const double off = m_left * std::abs(m_small(m_small.rows() - 1, 0));
        if (size <= maxDenseSize || off <= settled * std::abs(m_values.front()))
            return;
        start.setZero();
        for (Eigen::Index k = 0; k < std::min(blended, m_small.cols()); ++k) {
            const Eigen::VectorXcd one = m_basis * m_small.col(k);
            start += one.real() + one.imag();
        }
    }
}

void Spectrum::columnByColumn(int size, const Product &product)
{
    m_basis = Eigen::MatrixXd::Identity(size, size);
    Eigen::MatrixXd all(size, size);
    Vector column(size);
    for (int i = 0; i < size; ++i) {
        product(m_basis.col(i), column);
        all.col(i) = column;
    }
    sort(all);
}

void Spectrum::round(const Product &product, Vector start)
{
    const Eigen::Index size = start.size();
    const Eigen::Index most = std::min<Eigen::Index>(size, maxDenseSize);
    m_basis.resize(size, most);
    Eigen::MatrixXd small = Eigen::MatrixXd::Zero(most, most);
    m_basis.col(0) = start.normalized();
    Vector next(size);
    Eigen::Index used = 1;
    for (;; ++used) {
        product(m_basis.col(used - 1), next);
        const double before = next.norm();
        // Twice: what rounding leaves of the basis after once.
        for (int again = 0; again < 2; ++again) {
            const Vector along = m_basis.leftCols(used).transpose() * next;
            next -= m_basis.leftCols(used) * along;
            small.col(used - 1).head(used) += along;
        }
        m_left = next.norm();
        if (!(m_left > 1e-13 * before)) // nothing new, or nothing finite
            m_left = 0.0;
        if (m_left == 0.0 || used == most)
            break;
        small(used, used - 1) = m_left;
        m_basis.col(used) = next / m_left;
    }
    m_basis.conservativeResize(Eigen::NoChange, used);
    sort(small.topLeftCorner(used, used));
}

void Spectrum::sort(const Eigen::MatrixXd &small)
{
    m_values.clear();
    if (!small.allFinite()) {
        m_values.push_back(INFINITY);
        m_small = Eigen::MatrixXcd::Identity(small.rows(), 1);
        return;
    }
    m_rounding = lastDigits * small.norm();
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(small);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(small.rows()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto &values = solver.eigenvalues();
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return std::abs(values[a]) > std::abs(values[b]);
    });
    const Eigen::MatrixXcd vectors = solver.eigenvectors();
    m_small.resize(small.rows(), small.rows());
    for (std::size_t i = 0; i < order.size(); ++i) {
        m_values.push_back(values[order[i]]);
        m_small.col(static_cast<Eigen::Index>(i)) = vectors.col(order[i]);
    }
}

double Spectrum::radius() const
{
    return std::max(0.0, std::abs(m_values.front()) - m_rounding);
}

Eigen::VectorXcd Spectrum::vector(std::size_t index) const
{
    const Eigen::VectorXcd found = m_basis * m_small.col(static_cast<Eigen::Index>(index));
    const double length = found.norm();
    return length > 0.0 ? Eigen::VectorXcd(found / length) : found;
}

}
