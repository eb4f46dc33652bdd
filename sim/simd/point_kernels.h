#pragma once

#include "sim/scene/effect.h"
#include "sim/simd/dispatch.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sim {

/// The x and the y of all points, each in one run of memory.
struct XyColumns
{
    double *x;
    double *y;

    explicit XyColumns(Eigen::ArrayX2d &of) : x(of.data()), y(of.data() + of.rows()) {}
    Vec2 at(int point) const { return {x[point], y[point]}; }
};

/// What `points` and `others` have in common.
inline PointRange intersection(PointRange points, PointRange others)
{
    const int first = std::max(points.first, others.first);
    const int end = std::min(points.end(), others.end());
    return {first, std::max(0, end - first)};
}

/// The same points in ascending order, neighbouring runs made one.
std::vector<PointRange> sortedRanges(std::vector<PointRange> ranges);

/// Sets the numbers of `points` to 0.
inline void setZero(Eigen::ArrayX2d &columns, PointRange points)
{
    double *x = &columns(points.first, 0), *y = &columns(points.first, 1);
    for (int i = 0; i < points.count; ++i)
        x[i] = y[i] = 0.0;
}

/// Whether none of `points` has an inverse mass of 0.
inline bool areAllDynamic(const double *inverseMass, PointRange points)
{
    std::int64_t held = 0;
    for (int i = points.first; i < points.end(); ++i)
        held |= inverseMass[i] == 0.0 ? std::int64_t{1} : std::int64_t{0};
    return held == 0;
}

/// Runs `one(point, feels)` for each point of `points`, several at once. No point looks at another one.
template <class One>
void forEachPoint(const double *inverseMass, PointRange points, const One &one)
{
    dispatch([&] {
        const One work = one; // numbers that no store can change
        const double *share = inverseMass;
        const int first = points.first, end = points.end();
        if (areAllDynamic(share,
                          points)) { // as they mostly do: a store that depends takes longer than this look
            SIM_TURNS_ARE_APART
            for (int i = first; i < end; ++i)
                work(i, true);
            return;
        }
        SIM_TURNS_ARE_APART
        for (int i = first; i < end; ++i)
            work(i, share[i] != 0.0);
    });
}

/// Gives each point of `points` that feels forces what `rule(point)` says, a Vec2 for its row of `into`.
template <class Rule>
void updateDynamic(const Eigen::ArrayXd &inverseMass, PointRange points, Eigen::ArrayX2d &into,
                   const Rule &rule)
{
    forEachPoint(inverseMass.data(), points, [rule, at = XyColumns(into)](int i, bool feels) {
        const Vec2 value = rule(i);
        at.x[i] = feels ? value.x : at.x[i];
        at.y[i] = feels ? value.y : at.y[i];
    });
}

/// The same for one number a point.
template <class Rule>
void updateDynamic(const Eigen::ArrayXd &inverseMass, PointRange points, double *into, const Rule &rule)
{
    forEachPoint(inverseMass.data(), points, [rule, into](int i, bool feels) {
        const double value = rule(i);
        into[i] = feels ? value : into[i];
    });
}

/// The same for position and velocity at once: `rule(point)` says a value with `x` and `v`, both Vec2.
template <class Rule>
void updateDynamicMotion(State &state, PointRange points, const Rule &rule)
{
    const XyColumns position(state.position), velocity(state.velocity);
    forEachPoint(state.inverseMass.data(), points, [rule, x = position, v = velocity](int i, bool feels) {
        const auto after = rule(i);
        x.x[i] = feels ? after.x.x : x.x[i];
        x.y[i] = feels ? after.x.y : x.y[i];
        v.x[i] = feels ? after.v.x : v.x[i];
        v.y[i] = feels ? after.v.y : v.y[i];
    });
}

}
