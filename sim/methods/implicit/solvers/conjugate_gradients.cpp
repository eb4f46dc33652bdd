#include "sim/methods/implicit/solvers/conjugate_gradients.h"

#include "sim/base/random.h"

#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr int maxProductsPerPoint = 20;

/// Returns random numbers from -0.5 to 0.5.
Eigen::VectorXd randomVector(Eigen::Index size, std::uint64_t seed)
{
    Eigen::VectorXd numbers(size);
    for (Eigen::Index i = 0; i < size; ++i)
        numbers[i] = uniform(seed, 0, i) - 0.5;
    return numbers;
}

}

std::optional<SpringMatrix> SpringMatrix::of(const std::vector<Jacobian::Entry> &entries,
                                             const Eigen::VectorXd &weights)
{
    SpringMatrix matrix;
    if (!weights.array().isFinite().all() || !matrix.isSymmetric(entries, weights))
        return {};
    matrix.assemble(entries, weights);
    return matrix;
}

/// Returns whether u . A v = v . A u for two random vectors, up to rounding.
bool SpringMatrix::isSymmetric(const std::vector<Jacobian::Entry> &entries,
                               const Eigen::VectorXd &weights) const
{
    const Eigen::VectorXd u = randomVector(weights.size(), 1), v = randomVector(weights.size(), 2);
    double difference = 0.0, total = 0.0;
    for (const Jacobian::Entry &entry : entries) {
        const double value = weights[entry.row] * entry.value;
        difference += value * (u[entry.row] * v[entry.column] - v[entry.row] * u[entry.column]);
        total += std::abs(value);
    }
    return std::abs(difference) <= 1e-12 * total;
}

void SpringMatrix::assemble(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &weights)
{
    const auto points = static_cast<int>(weights.size() / 2);
    m_pointBlocks.resize(static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i) {
        m_pointBlocks[static_cast<std::size_t>(i)].xx = weights[i];
        m_pointBlocks[static_cast<std::size_t>(i)].yy = weights[points + i];
    }
    const auto add = [](auto &block, bool rowIsY, bool columnIsY, double value) {
        (rowIsY ? (columnIsY ? block.yy : block.yx) : (columnIsY ? block.xy : block.xx)) += value;
    };
    for (const Jacobian::Entry &entry : entries) {
        const int a = entry.row % points, b = entry.column % points;
        const bool rowIsY = entry.row >= points, columnIsY = entry.column >= points;
        const double value = weights[entry.row] * entry.value;
        if (a == b) {
            add(m_pointBlocks[static_cast<std::size_t>(a)], rowIsY, columnIsY, value);
        } else if (a < b) {
            if (m_springBlocks.empty() || m_springBlocks.back().a != a || m_springBlocks.back().b != b)
                m_springBlocks.push_back({a, b});
            add(m_springBlocks.back(), rowIsY, columnIsY, value);
        }
    }
}

void SpringMatrix::multiply(const Eigen::VectorXd &x, Eigen::VectorXd &product) const
{
    const double *from = x.data();
    double *to = product.data();
    for (std::size_t i = 0; i < m_pointBlocks.size(); ++i) {
        const PointBlock &block = m_pointBlocks[i];
        to[2 * i] = block.xx * from[2 * i] + block.xy * from[2 * i + 1];
        to[2 * i + 1] = block.yx * from[2 * i] + block.yy * from[2 * i + 1];
    }
    for (const SpringBlock &spring : m_springBlocks) {
        const double ax = from[2 * spring.a], ay = from[2 * spring.a + 1];
        const double bx = from[2 * spring.b], by = from[2 * spring.b + 1];
        to[2 * spring.a] += spring.xx * bx + spring.xy * by;
        to[2 * spring.a + 1] += spring.yx * bx + spring.yy * by;
        to[2 * spring.b] += spring.xx * ax + spring.yx * ay;
        to[2 * spring.b + 1] += spring.xy * ax + spring.yy * ay;
    }
}

Eigen::VectorXd SpringMatrix::diagonal() const
{
    Eigen::VectorXd numbers(2 * points());
    for (int i = 0; i < points(); ++i) {
        numbers[2 * i] = m_pointBlocks[static_cast<std::size_t>(i)].xx;
        numbers[2 * i + 1] = m_pointBlocks[static_cast<std::size_t>(i)].yy;
    }
    return numbers;
}

ConjugateResult conjugateGradients(const SpringMatrix &matrix, const Eigen::VectorXd &right, double tolerance)
{
    const Eigen::VectorXd scale = matrix.diagonal().cwiseInverse();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
    Eigen::VectorXd residual = right, scaled = scale.cwiseProduct(right), direction = scaled, product = right;
    double residualDotScaled = residual.dot(scaled);
    const double squaredTolerance = tolerance * tolerance * right.squaredNorm();
    ConjugateResult found{x, 0};
    while (residual.squaredNorm() > squaredTolerance) {
        matrix.multiply(direction, product);
        const double curvature = direction.dot(product);
        // Written so that NaN fails too.
        if (!(curvature > 0.0) || !(residualDotScaled > 0.0) ||
            ++found.iterations > maxProductsPerPoint * matrix.points()) {
            found.x.setConstant(std::numeric_limits<double>::quiet_NaN());
            return found;
        }
        const double length = residualDotScaled / curvature;
        x += length * direction;
        residual -= length * product;
        scaled = scale.cwiseProduct(residual);
        const double next = residual.dot(scaled);
        direction = scaled + (next / residualDotScaled) * direction;
        residualDotScaled = next;
    }
    found.x = x;
    return found;
}

Eigen::VectorXd interleaved(const Eigen::VectorXd &columns)
{
    Eigen::VectorXd pairs(columns.size());
    const Eigen::Index points = columns.size() / 2;
    for (Eigen::Index i = 0; i < points; ++i) {
        pairs[2 * i] = columns[i];
        pairs[2 * i + 1] = columns[points + i];
    }
    return pairs;
}

Eigen::VectorXd separated(const Eigen::VectorXd &pairs)
{
    Eigen::VectorXd columns(pairs.size());
    const Eigen::Index points = pairs.size() / 2;
    for (Eigen::Index i = 0; i < points; ++i) {
        columns[i] = pairs[2 * i];
        columns[points + i] = pairs[2 * i + 1];
    }
    return columns;
}

}
