#include "sim/analysis/stability/modes/dominant_effect.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace sim {

namespace {

constexpr std::size_t mostMovers = 3;

/// The pattern for all rows of q: what does not go on by itself stays.
Eigen::VectorXcd spread(const LinearisedScene &linearised, const Eigen::VectorXcd &rows)
{
    const State &start = linearised.scene.start;
    Eigen::VectorXcd all = Eigen::VectorXcd::Zero(2 * start.pointCount() + start.angle.rows());
    for (std::size_t i = 0; i < linearised.rows.size(); ++i)
        all[linearised.rows[i]] = rows[static_cast<Eigen::Index>(i)];
    return all;
}

}

DominantEffect dominantEffectOf(const LinearisedScene &linearised, const Eigen::VectorXcd &rows)
{
    const int points = linearised.scene.start.pointCount();
    const Eigen::VectorXcd q = spread(linearised, rows);
    // Where a point `of` is from a point `from`, on the axis of `row`.
    const auto apart = [&](int row, int of, int from) {
        const int axis = row / points * points;
        return q[axis + of] - (from < 0 ? 0.0 : q[axis + from]);
    };
    std::map<std::tuple<std::size_t, int, int>, double> work;
    for (std::size_t i = 0; i < linearised.parts.size(); ++i) {
        // A link's entry for its own point and the one for its other end add up to nothing; what is left of them pulls to
        // a place.
        for (const Jacobian::Entry &one : linearised.parts[i].entries) {
            const int point = one.row % points, other = one.column % points;
            const auto alone = apart(one.row, point, -1), by = apart(one.column, point, -1);
            work[{i, point, -1}] -= (std::conj(alone) * one.value * by).real();
            if (point == other)
                continue;
            const auto mine = apart(one.row, point, other), its = apart(one.column, point, other);
            work[{i, std::min(point, other), std::max(point, other)}] +=
                (std::conj(mine) * one.value * its).real();
        }
    }
    const auto most = std::max_element(work.begin(), work.end(),
                                       [](const auto &a, const auto &b) { return a.second < b.second; });
    if (most == work.end() || !(most->second > 0.0))
        return {};
    const auto &[part, point, other] = most->first;
    return {linearised.parts[part].effect, point, other};
}

std::vector<int> largestMovers(const LinearisedScene &linearised, const Eigen::VectorXcd &rows)
{
    const int points = linearised.scene.start.pointCount();
    const Eigen::VectorXcd q = spread(linearised, rows);
    std::vector<double> far(static_cast<std::size_t>(points), 0.0);
    for (Eigen::Index row = 0; row < q.size(); ++row)
        far[static_cast<std::size_t>(row % points)] += std::norm(q[row]);
    std::vector<int> movers(far.size());
    std::iota(movers.begin(), movers.end(), 0);
    const auto farOf = [&](int point) { return far[static_cast<std::size_t>(point)]; };
    std::stable_sort(movers.begin(), movers.end(), [&](int a, int b) { return farOf(a) > farOf(b); });
    std::erase_if(movers, [&, most = farOf(movers.front())](int point) {
        return !(farOf(point) >= 0.25 * most) || farOf(point) == 0.0;
    });
    movers.resize(std::min(movers.size(), mostMovers));
    return movers;
}

}
