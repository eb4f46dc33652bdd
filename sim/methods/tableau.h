#pragma once

#include <array>

namespace sim {

/// The numbers of an explicit Runge-Kutta method: stage i is taken at the time c[i] of a step, at the place that
/// the slopes of the stages before it lead to, with weights a[i]; the step itself has weights b.
/// Source: Butcher, "Numerical methods for ordinary differential equations", section 232.
struct Tableau
{
    static constexpr int most = 16;
    using Row = std::array<double, most>;

    int stages = 0;
    Row c{};
    std::array<Row, most> a{};
    Row b{};
};

/// What a step of h frames does with the slopes of its stages, for velocities that damping slows at a rate of c per
/// frame. That damping is exact: v = e^(-c t) u, and the method takes u, which nothing slows, through its stages.
/// Then stage i has the velocity keep[i] v0 + sum of speed[i][j] a_j.
/// Source: Lawson, "Generalized Runge-Kutta processes for stable systems with large Lipschitz constants", 1967.
struct StageWeights
{
    std::array<Tableau::Row, Tableau::most + 1> place{};
    std::array<Tableau::Row, Tableau::most + 1> speed{};
    std::array<double, Tableau::most + 1> keep{};

    /// Of the first `rows` rows of the tableau's a, and as one more of the step itself, which has weights b. An infinite
    /// rate stops everything: all weights are 0.
    void set(const Tableau &tableau, double rate, double h, int rows);
};

/// out = share * base + sum of weights[j] * columns[j], number by number.
/// @param columns one after the other, `size` numbers each
// Shown lines are short.
// clang-format off
inline
//! [blend]
void blend(
    double *out, const double *base,
    double share, const double *columns,
    const double *weights, int count,
    int first, int end, int size)
{
    for (int i = first; i < end; ++i)
        out[i] = share * base[i];
    for (int j = 0; j < count; ++j) {
        double w = weights[j];
        const double *slope =
            columns + j * size;
        for (int i = first; i < end; ++i)
            out[i] += w * slope[i];
    }
}
//! [blend]
// clang-format on

}
