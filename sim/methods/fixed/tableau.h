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

    /// What the weights are for: asked for the same again, set() leaves them.
    const Tableau *tableau = nullptr;
    double rate = 0.0;
    double h = 0.0;
    int rows = 0;

    /// Of the first `count` rows of the tableau's a, and as one more of the step itself, which has weights b. An infinite
    /// rate c stops everything: all weights are 0.
    void set(const Tableau &of, double c, double step, int count);
};

/// sum = share * base + sum of weights[j] * columns[j], for `lanes` numbers: few enough to stay in registers.
/// @param columns one after the other, `size` numbers each
// Shown lines are short.
// clang-format off
template <int lanes>
//! [blend]
void blend(
    double *out, const double *base,
    double share, const double *columns,
    const double *weights, int count,
    int size)
{
    double sum[lanes];
    for (int i = 0; i < lanes; ++i)
        sum[i] = share * base[i];
    for (int j = 0; j < count; ++j) {
        double w = weights[j];
        const double *slope =
            columns + j * size;
        if (w == 0)
            continue;
        for (int i = 0; i < lanes; ++i)
            sum[i] += w * slope[i];
    }
    for (int i = 0; i < lanes; ++i)
        out[i] = sum[i];
}
//! [blend]
// clang-format on

/// The same for the rows from `first` to before `end`.
inline void blendRows(double *out, const double *base, double share, const double *columns,
                      const double *weights, int count, int first, int end, int size)
{
    int i = first;
    for (; i + 8 <= end; i += 8)
        blend<8>(out + i, base + i, share, columns + i, weights, count, size);
    for (; i + 4 <= end; i += 4)
        blend<4>(out + i, base + i, share, columns + i, weights, count, size);
    for (; i < end; ++i)
        blend<1>(out + i, base + i, share, columns + i, weights, count, size);
}

}
