#include "sim/run/sleeping/block_cycle_detector.h"

#include "sim/pipeline/pipeline.h"
#include "sim/scene/state.h"

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

/// Returns whether `points` have the same bits in two arrays with one row per point. The arrays may be empty.
template <class Array>
bool sameRows(const Array &a, const Array &b, PointRange points)
{
    if (a.rows() != b.rows() || a.cols() != b.cols())
        return false;
    const auto bytes = static_cast<std::size_t>(points.count) * sizeof *a.data();
    for (Eigen::Index column = 0; a.rows() > 0 && column < a.cols(); ++column) {
        if (std::memcmp(&a(points.first, column), &b(points.first, column), bytes) != 0)
            return false;
    }
    return true;
}

bool sameRows(const State &a, const State &b, PointRange points)
{
    bool same = true;
    forEachColumn([&](ColumnKind kind, auto values) {
        same = same && (kind == ColumnKind::scratch || sameRows(a.*values, b.*values, points));
    });
    return same;
}

}

void BlockCycleDetector::check(const Pipeline &pipeline, const State &before, const State &after)
{
    wakeAll();
    if (after.stages.size() > 0)
        return;
    m_asleep.assign(pipeline.blocks.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i < m_asleep.size(); ++i) {
        const CacheBlock &block = pipeline.blocks[i];
        const bool isDragged = block.contains(before.hold.point) || block.contains(after.hold.point);
        const bool repeats =
            !isDragged && std::all_of(block.ranges.begin(), block.ranges.end(),
                                      [&](PointRange range) { return sameRows(before, after, range); });
        m_asleep[i] = repeats ? 1 : 0;
        any = any || repeats;
    }
    if (!any)
        wakeAll();
}

void BlockCycleDetector::wake(const Pipeline &pipeline, int point)
{
    for (std::size_t i = 0; point >= 0 && i < m_asleep.size(); ++i) {
        if (m_asleep[i] != 0 && pipeline.blocks[i].contains(point))
            m_asleep[i] = 0;
    }
}

}
