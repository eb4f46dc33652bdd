#include "sim/methods/implicit/solvers/conjugate_gradients.h"

#include "sim/base/random.h"

#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr int mostProducts = 20; ///< a point

/// Numbers in which no accident hides a difference.
Eigen::VectorXd probe(Eigen::Index size, std::uint64_t seed)
{
    Eigen::VectorXd numbers(size);
    for (Eigen::Index i = 0; i < size; ++i)
        numbers[i] = uniform(seed, 0, static_cast<std::uint64_t>(i)) - 0.5;
    return numbers;
}

}

std::optional<SpringMatrix> SpringMatrix::of(const std::vector<Jacobian::Entry> &entries,
                                             const Eigen::VectorXd &weights)
{
    SpringMatrix matrix;
    if (!weights.array().isFinite().all() || !matrix.mirrors(entries, weights))
        return {};
    matrix.gather(entries, weights);
    return matrix;
}

/// Whether both sides of the diagonal give u A v the same sum as v A u, for two vectors that have nothing to do with
/// any scene.
bool SpringMatrix::mirrors(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &weights) const
{
    const Eigen::VectorXd u = probe(weights.size(), 1), v = probe(weights.size(), 2);
    double difference = 0.0, all = 0.0;
    for (const Jacobian::Entry &entry : entries) {
        const double value = weights[entry.row] * entry.value;
        difference += value * (u[entry.row] * v[entry.column] - v[entry.row] * u[entry.column]);
        all += std::abs(value);
    }
    return std::abs(difference) <= 1e-12 * all;
}

void SpringMatrix::gather(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &weights)
{
    const auto points = static_cast<int>(weights.size() / 2);
    m_own.resize(static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i) {
        m_own[static_cast<std::size_t>(i)].xx = weights[i];
        m_own[static_cast<std::size_t>(i)].yy = weights[points + i];
    }
    const auto add = [](auto &block, bool ofY, bool byY, double value) {
        (ofY ? (byY ? block.yy : block.yx) : (byY ? block.xy : block.xx)) += value;
    };
    for (const Jacobian::Entry &entry : entries) {
        const int a = entry.row % points, b = entry.column % points;
        const bool ofY = entry.row >= points, byY = entry.column >= points;
        const double value = weights[entry.row] * entry.value;
        if (a == b) {
            add(m_own[static_cast<std::size_t>(a)], ofY, byY, value);
        } else if (a < b) {
            if (m_between.empty() || m_between.back().a != a || m_between.back().b != b)
                m_between.push_back({a, b});
            add(m_between.back(), ofY, byY, value);
        }
    }
}

void SpringMatrix::multiply(const Eigen::VectorXd &x, Eigen::VectorXd &into) const
{
    const double *from = x.data();
    double *to = into.data();
    for (std::size_t i = 0; i < m_own.size(); ++i) {
        const Own &own = m_own[i];
        to[2 * i] = own.xx * from[2 * i] + own.xy * from[2 * i + 1];
        to[2 * i + 1] = own.yx * from[2 * i] + own.yy * from[2 * i + 1];
    }
    for (const Between &spring : m_between) {
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
        numbers[2 * i] = m_own[static_cast<std::size_t>(i)].xx;
        numbers[2 * i + 1] = m_own[static_cast<std::size_t>(i)].yy;
    }
    return numbers;
}

Conjugate conjugateGradients(const SpringMatrix &matrix, const Eigen::VectorXd &right, double tolerance)
{
    const Eigen::VectorXd scale = matrix.diagonal().cwiseInverse();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
    Eigen::VectorXd missed = right, scaled = scale.cwiseProduct(right), way = scaled, product = right;
    double left = missed.dot(scaled);
    const double enough = tolerance * tolerance * right.squaredNorm();
    Conjugate found{x, 0};
    while (missed.squaredNorm() > enough) {
        matrix.multiply(way, product);
        const double bend = way.dot(product);
        // Also where a number is not finite.
        if (!(bend > 0.0) || !(left > 0.0) || ++found.iterations > mostProducts * matrix.points()) {
            found.x.setConstant(std::numeric_limits<double>::quiet_NaN());
            return found;
        }
        const double length = left / bend;
        x += length * way;
        missed -= length * product;
        scaled = scale.cwiseProduct(missed);
        const double next = missed.dot(scaled);
        way = scaled + (next / left) * way;
        left = next;
    }
    found.x = x;
    return found;
}

Eigen::VectorXd inTurn(const Eigen::VectorXd &columns)
{
    Eigen::VectorXd turns(columns.size());
    const Eigen::Index points = columns.size() / 2;
    for (Eigen::Index i = 0; i < points; ++i) {
        turns[2 * i] = columns[i];
        turns[2 * i + 1] = columns[points + i];
    }
    return turns;
}

Eigen::VectorXd inColumns(const Eigen::VectorXd &turns)
{
    Eigen::VectorXd columns(turns.size());
    const Eigen::Index points = turns.size() / 2;
    for (Eigen::Index i = 0; i < points; ++i) {
        columns[i] = turns[2 * i];
        columns[points + i] = turns[2 * i + 1];
    }
    return columns;
}

}
