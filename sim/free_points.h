#pragma once

#include "sim/effect.h"
#include "sim/wide.h"

#include <algorithm>

namespace sim {

/// The x and the y of all points, each in one run of memory.
struct Columns
{
    double *x;
    double *y;

    explicit Columns(Eigen::ArrayX2d &of) : x(of.data()), y(of.data() + of.rows()) {}
    Vec2 at(int point) const { return {x[point], y[point]}; }
};

/// What `points` and `others` have in common.
inline Points common(Points points, Points others)
{
    const int first = std::max(points.first, others.first);
    const int end = std::min(points.end(), others.end());
    return {first, std::max(0, end - first)};
}

/// Gives each point of `points` that feels forces what `rule(point)` says, a Vec2 for its row of `into`. A rule looks
/// at no other point, so several points are computed at once.
template <class Rule>
void replaceFree(const Eigen::ArrayXd &inverseMass, Points points, Eigen::ArrayX2d &into, const Rule &rule)
{
    const double *weight = inverseMass.data();
    const Columns column(into);
    runFast([&] {
        const Rule compute = rule; // numbers that no store can change
        const double *share = weight;
        double *x = column.x, *y = column.y;
        const int end = points.end();
        SIM_TURNS_ARE_APART
        for (int i = points.first; i < end; ++i) {
            const Vec2 value = compute(i);
            x[i] = share[i] != 0.0 ? value.x : x[i];
            y[i] = share[i] != 0.0 ? value.y : y[i];
        }
    });
}

/// The same for one number a point.
template <class Rule>
void replaceFree(const Eigen::ArrayXd &inverseMass, Points points, double *into, const Rule &rule)
{
    const double *weight = inverseMass.data();
    runFast([&] {
        const Rule compute = rule;
        const double *share = weight;
        double *column = into;
        const int end = points.end();
        SIM_TURNS_ARE_APART
        for (int i = points.first; i < end; ++i) {
            const double value = compute(i);
            column[i] = share[i] != 0.0 ? value : column[i];
        }
    });
}

/// The same for position and velocity at once: `rule(point)` says a value with `x` and `v`, both Vec2.
template <class Rule>
void replaceFreeMotion(State &state, Points points, const Rule &rule)
{
    const double *weight = state.inverseMass.data();
    const Columns position(state.position), velocity(state.velocity);
    runFast([&] {
        const Rule compute = rule;
        const double *share = weight;
        const Columns x = position, v = velocity;
        const int end = points.end();
        SIM_TURNS_ARE_APART
        for (int i = points.first; i < end; ++i) {
            const auto after = compute(i);
            x.x[i] = share[i] != 0.0 ? after.x.x : x.x[i];
            x.y[i] = share[i] != 0.0 ? after.x.y : x.y[i];
            v.x[i] = share[i] != 0.0 ? after.v.x : v.x[i];
            v.y[i] = share[i] != 0.0 ? after.v.y : v.y[i];
        }
    });
}

}
