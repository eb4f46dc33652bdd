#include "sim/run/finite.h"

#include "sim/simd/dispatch.h"

#include <atomic>
#include <cstdint>

namespace sim {

namespace {

/// The points that one task checks. They take about 20 us, far more than the pool needs to start a task.
constexpr int pointsPerTask = 16'384;

/// Returns 0 if the numbers of `points` in `column` are finite, else 1. An integer, so that the loop
/// vectorises.
template <class Number>
SIM_INLINED inline std::int64_t notFinite(const Number *column, PointRange points)
{
    std::int64_t found = 0;
    // x - x is 0 for every finite x, else NaN
    for (int i = points.first; i < points.end(); ++i)
        found |= column[i] - column[i] == Number{0} ? std::int64_t{0} : std::int64_t{1};
    return found;
}

}

bool areFinite(const State &state, PointRange points)
{
    std::int64_t nonFinite = 0;
    dispatch([&] {
        std::int64_t found = 0;
        forEachColumn([&](ColumnKind kind, auto values) {
            const auto &array = state.*values;
            const Eigen::Index columns = mustBeFinite(kind) && array.rows() > 0 ? array.cols() : 0;
            for (Eigen::Index column = 0; column < columns; ++column)
                found |= notFinite(array.data() + column * array.rows(), points);
        });
        nonFinite = found;
    });
    return nonFinite == 0;
}

bool isFinite(const State &state, ThreadPool &pool)
{
    if (!state.gait.isFinite().all() || !state.gaitSpeed.isFinite().all())
        return false;
    const int points = state.pointCount();
    const int tasks = points / pointsPerTask;
    if (tasks < 2)
        return areFinite(state, {0, points});
    std::atomic<bool> allFinite = true;
    pool.parallelFor(tasks, [&](int task) {
        const auto firstOf = [&](int number) {
            return static_cast<int>(std::int64_t{points} * number / tasks);
        };
        if (!areFinite(state, {firstOf(task), firstOf(task + 1) - firstOf(task)}))
            allFinite = false;
    });
    return allFinite;
}

int firstNonFinitePoint(const State &state)
{
    const bool clocksAreFinite = state.gait.isFinite().all() && state.gaitSpeed.isFinite().all();
    if (clocksAreFinite && areFinite(state, {0, state.pointCount()}))
        return -1;
    for (int i = 0; i < state.pointCount(); ++i) {
        if (!areFinite(state, {i, 1}))
            return i;
    }
    return state.pointCount();
}

}
