#include "sim/run/finite.h"

#include "sim/simd/dispatch.h"

#include <atomic>
#include <cstdint>

namespace sim {

namespace {

/// A part that one thread looks at: about 20 us, far more than handing it out takes.
constexpr int pointsInPart = 16'384;

/// Returns 0 if the numbers of `points` in one column are finite, else 1.
template <class Number>
std::int64_t notFinite(const Number *column, PointRange points)
{
    std::int64_t found = 0;
    // x - x is 0 for every finite x, and NaN for the others
    for (int i = points.first; i < points.end(); ++i)
        found |= column[i] - column[i] == Number{0} ? std::int64_t{0} : std::int64_t{1};
    return found;
}

}

bool areFinite(const State &state, PointRange points)
{
    std::int64_t others = 0;
    dispatch([&] {
        std::int64_t found = 0;
        forEachColumn([&](ColumnKind kind, auto values) {
            const auto &array = state.*values;
            const Eigen::Index columns = mustBeFinite(kind) && array.rows() > 0 ? array.cols() : 0;
            for (Eigen::Index column = 0; column < columns; ++column)
                found |= notFinite(array.data() + column * array.rows(), points);
        });
        others = found;
    });
    return others == 0;
}

bool isFinite(const State &state, ThreadPool &pool)
{
    if (!state.gait.isFinite().all() || !state.gaitSpeed.isFinite().all())
        return false;
    const int points = state.pointCount();
    const int parts = points / pointsInPart;
    if (parts < 2)
        return areFinite(state, {0, points});
    std::atomic<bool> all = true;
    pool.parallelFor(parts, [&](int part) {
        const auto from = [&](int number) { return static_cast<int>(std::int64_t{points} * number / parts); };
        if (!areFinite(state, {from(part), from(part + 1) - from(part)}))
            all = false;
    });
    return all;
}

int firstNonFinitePoint(const State &state)
{
    const bool clocks = state.gait.isFinite().all() && state.gaitSpeed.isFinite().all();
    if (clocks && areFinite(state, {0, state.pointCount()}))
        return -1;
    for (int i = 0; i < state.pointCount(); ++i) {
        if (!areFinite(state, {i, 1}))
            return i;
    }
    return state.pointCount();
}

}
