#include "sim/analysis/stability/modes/dominant_effect.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace sim {

namespace {

constexpr std::size_t maxMovers = 3;

/// Returns the mode with all rows of q. Rows that are not dynamic are 0.
Eigen::VectorXcd allRows(const LinearisedScene &linearised, const Eigen::VectorXcd &rows)
{
    const State &start = linearised.scene.start;
    Eigen::VectorXcd vector = Eigen::VectorXcd::Zero(2 * start.pointCount() + start.angle.rows());
    for (std::size_t i = 0; i < linearised.rows.size(); ++i)
        vector[linearised.rows[i]] = rows[static_cast<Eigen::Index>(i)];
    return vector;
}

}

DominantEffect dominantEffectOf(const LinearisedScene &linearised, const Eigen::VectorXcd &rows)
{
    const int points = linearised.scene.start.pointCount();
    const Eigen::VectorXcd q = allRows(linearised, rows);
    // The displacement of point `moving` relative to point `from` (-1: absolute), on the axis of `row`.
    const auto displacement = [&](int row, int moving, int from) {
        const int axis = row / points * points;
        return q[axis + moving] - (from < 0 ? 0.0 : q[axis + from]);
    };
    std::map<std::tuple<std::size_t, int, int>, double> work;
    for (std::size_t i = 0; i < linearised.effectJacobians.size(); ++i) {
        // The entries of a spring for its own point and for its other end cancel. A remainder belongs to a
        // spring to a fixed position.
        for (const Jacobian::Entry &entry : linearised.effectJacobians[i].entries) {
            const int point = entry.row % points, other = entry.column % points;
            const auto rowDisplacement = displacement(entry.row, point, -1),
                       columnDisplacement = displacement(entry.column, point, -1);
            work[{i, point, -1}] -= (std::conj(rowDisplacement) * entry.value * columnDisplacement).real();
            if (point == other)
                continue;
            const auto relativeRow = displacement(entry.row, point, other),
                       relativeColumn = displacement(entry.column, point, other);
            work[{i, std::min(point, other), std::max(point, other)}] +=
                (std::conj(relativeRow) * entry.value * relativeColumn).real();
        }
    }
    const auto largest = std::max_element(work.begin(), work.end(),
                                          [](const auto &a, const auto &b) { return a.second < b.second; });
    if (largest == work.end() || !(largest->second > 0.0))
        return {};
    const auto &[index, point, other] = largest->first;
    return {linearised.effectJacobians[index].effect, point, other};
}

std::vector<int> largestMovers(const LinearisedScene &linearised, const Eigen::VectorXcd &rows)
{
    const int points = linearised.scene.start.pointCount();
    const Eigen::VectorXcd q = allRows(linearised, rows);
    std::vector<double> squaredDistance(static_cast<std::size_t>(points), 0.0);
    for (Eigen::Index row = 0; row < q.size(); ++row)
        squaredDistance[static_cast<std::size_t>(row % points)] += std::norm(q[row]);
    std::vector<int> movers(squaredDistance.size());
    std::iota(movers.begin(), movers.end(), 0);
    const auto squaredDistanceOf = [&](int point) {
        return squaredDistance[static_cast<std::size_t>(point)];
    };
    std::stable_sort(movers.begin(), movers.end(),
                     [&](int a, int b) { return squaredDistanceOf(a) > squaredDistanceOf(b); });
    std::erase_if(movers, [&, largest = squaredDistanceOf(movers.front())](int point) {
        return !(squaredDistanceOf(point) >= 0.25 * largest) || squaredDistanceOf(point) == 0.0;
    });
    movers.resize(std::min(movers.size(), maxMovers));
    return movers;
}

}
