#pragma once

#include <array>

namespace sim {

/// The coefficients of an explicit Runge-Kutta method (Butcher tableau). The derivatives at the earlier
/// stages give the position of stage i, with weights a[i].
/// Source: Butcher, "Numerical methods for ordinary differential equations", section 232.
struct Tableau
{
    static constexpr int maxStages = 16;
    using Row = std::array<double, maxStages>;

    int stages = 0;
    Row c{};                        ///< time of each stage, as a share of the step
    std::array<Row, maxStages> a{}; ///< weights of the earlier stages, per stage
    Row b{};                        ///< weights of all stages for the step
};

/// The weights of the stages in a step of h frames, for a damping rate of c per frame. Damping is exact,
/// because the method integrates the undamped velocity u = e^(c t) v. So stage i has the velocity keep[i] v0
/// + sum of velocity[i][j] a_j, and the position x0 + sum of position[i][j] v_j.
/// Source: Lawson, "Generalized Runge-Kutta processes for stable systems with large Lipschitz constants",
/// 1967.
struct StageWeights
{
    std::array<Tableau::Row, Tableau::maxStages + 1> position{}; ///< frames
    std::array<Tableau::Row, Tableau::maxStages + 1> velocity{}; ///< frames
    std::array<double, Tableau::maxStages + 1> keep{};           ///< damping factor e^(-c t) at each stage

    /// The arguments of the last set().
    const Tableau *tableau = nullptr;
    double rate = 0.0;
    double h = 0.0;
    int rows = 0;

    /// Computes the weights of the first `count` stages, and in one more row those of the step itself. If c
    /// is infinite, all weights are 0. Does nothing if the arguments are the same as last time.
    void set(const Tableau &coefficients, double c, double step, int count);
};

/// Computes out = share * base + sum of weights[j] * columns[j] for `lanes` numbers, few enough to stay in
/// registers.
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
        const double *column =
            columns + j * size;
        if (w == 0)
            continue;
        for (int i = 0; i < lanes; ++i)
            sum[i] += w * column[i];
    }
    for (int i = 0; i < lanes; ++i)
        out[i] = sum[i];
}
//! [blend]
// clang-format on

/// Does the same for the rows from `first` to `end` - 1.
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
