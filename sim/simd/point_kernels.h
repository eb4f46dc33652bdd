#pragma once

#include "sim/scene/effect.h"
#include "sim/simd/dispatch.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sim {

/// Pointers to the x and y columns of an array with one row per point.
struct XyColumns
{
    double *x;
    double *y;

    explicit XyColumns(Eigen::ArrayX2d &array) : x(array.data()), y(array.data() + array.rows()) {}
    Vec2 at(int point) const { return {x[point], y[point]}; }
};

/// Returns the points that are in both ranges.
inline PointRange intersection(PointRange points, PointRange others)
{
    const int first = std::max(points.first, others.first);
    const int end = std::min(points.end(), others.end());
    return {first, std::max(0, end - first)};
}

/// Returns the ranges in ascending order, with neighbouring ranges merged.
std::vector<PointRange> sortedRanges(std::vector<PointRange> ranges);

/// Sets the rows of `points` to 0.
inline void setZero(Eigen::ArrayX2d &columns, PointRange points)
{
    double *x = &columns(points.first, 0), *y = &columns(points.first, 1);
    for (int i = 0; i < points.count; ++i)
        x[i] = y[i] = 0.0;
}

/// Returns how many of `points` are dynamic in `state`.
inline int countDynamic(const State &state, PointRange points)
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

/// Returns whether no point of `points` has the inverse mass 0.
SIM_INLINED inline bool areAllDynamic(const double *inverseMass, PointRange points)
{
    std::int64_t anyFixed = 0;
    for (int i = points.first; i < points.end(); ++i)
        anyFixed |= inverseMass[i] == 0.0 ? std::int64_t{1} : std::int64_t{0};
    return anyFixed == 0;
}

/// Calls `kernel(point, isDynamic)` for each point of `points` in a vectorised loop. A call must not read
/// what a call for another point writes.
template <class PointKernel>
void forEachPoint(const double *inverseMass, PointRange points, const PointKernel &kernel)
{
    dispatch([&] {
        // Local copies, so the compiler knows that no store of the loop changes them.
        const PointKernel work = kernel;
        const double *localInverseMass = inverseMass;
        const int first = points.first, end = points.end();
        // The usual case. Checking first takes less time than conditional stores.
        if (areAllDynamic(localInverseMass, points)) {
            SIM_INDEPENDENT_ITERATIONS
            for (int i = first; i < end; ++i)
                work(i, true);
            return;
        }
        SIM_INDEPENDENT_ITERATIONS
        for (int i = first; i < end; ++i)
            work(i, localInverseMass[i] != 0.0);
    });
}

/// Sets the row of each dynamic point of `points` to `rule(point)`, a Vec2.
template <class Rule>
void updateDynamic(const Eigen::ArrayXd &inverseMass, PointRange points, Eigen::ArrayX2d &rows,
                   const Rule &rule)
{
    forEachPoint(inverseMass.data(), points, [rule, columns = XyColumns(rows)](int i, bool isDynamic) {
        const Vec2 value = rule(i);
        columns.x[i] = isDynamic ? value.x : columns.x[i];
        columns.y[i] = isDynamic ? value.y : columns.y[i];
    });
}

/// Sets the number of each dynamic point of `points` to `rule(point)`, a double.
template <class Rule>
void updateDynamic(const Eigen::ArrayXd &inverseMass, PointRange points, double *numbers, const Rule &rule)
{
    forEachPoint(inverseMass.data(), points, [rule, numbers](int i, bool isDynamic) {
        const double value = rule(i);
        numbers[i] = isDynamic ? value : numbers[i];
    });
}

/// Sets the position and velocity of each dynamic point of `points` to the `x` and `v` of `rule(point)`, both
/// Vec2.
template <class Rule>
void updateDynamicMotion(State &state, PointRange points, const Rule &rule)
{
    const XyColumns position(state.position), velocity(state.velocity);
    forEachPoint(state.inverseMass.data(), points, [rule, x = position, v = velocity](int i, bool isDynamic) {
        const auto after = rule(i);
        x.x[i] = isDynamic ? after.x.x : x.x[i];
        x.y[i] = isDynamic ? after.x.y : x.y[i];
        v.x[i] = isDynamic ? after.v.x : v.x[i];
        v.y[i] = isDynamic ? after.v.y : v.y[i];
    });
}

}
