#include "tests/bench/peers/creature_in_air.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>

namespace bench::air {

namespace {

std::vector<Contender> &contenders()
{
    static std::vector<Contender> all;
    return all;
}

using Exact = Row<long double>;

Exact moved(const Exact &from, const Exact &change, long double h)
{
    Exact to = from;
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] += h * change[i];
    return to;
}

/// Returns the state after `h` frames by the modified midpoint rule in `steps` steps.
Exact midpoints(const Exact &from, long double h, int steps, long double c)
{
    const long double part = h / steps;
    Exact change{}, before = from;
    rates(from, change, c);
    Exact now = moved(from, change, part);
    for (int i = 1; i < steps; ++i) {
        rates(now, change, c);
        const Exact next = moved(before, change, 2 * part);
        before = now;
        now = next;
    }
    rates(now, change, c);
    for (std::size_t i = 0; i < now.size(); ++i)
        now[i] = (before[i] + now[i] + part * change[i]) / 2;
    return now;
}

/// Returns the reference solution: Gragg's extrapolation of the modified midpoint rule to order 20, in long
/// double. Source: Hairer, Norsett and Wanner, "Solving ordinary differential equations I", section II.9.
Exact extrapolated(const Exact &from, long double h, long double c)
{
    constexpr int columns = 10;
    std::array<Exact, columns> row;
    for (int j = 0; j < columns; ++j) {
        Exact better = midpoints(from, h, 2 * (j + 1), c);
        for (int m = 0; m < j; ++m) { // from the newest entry on, towards higher orders
            const long double ratio = static_cast<long double>(j + 1) / static_cast<long double>(j - m);
            Exact next = better;
            for (std::size_t i = 0; i < next.size(); ++i)
                next[i] += (better[i] - row[std::size_t(m)][i]) / (ratio * ratio - 1);
            row[std::size_t(m)] = better;
            better = next;
        }
        row[std::size_t(j)] = better;
    }
    return row[columns - 1];
}

const MeasureSeries &truth()
{
    static const MeasureSeries series = [] {
        const long double c = -std::log(static_cast<long double>(damp));
        Exact now{};
        const Row<double> first = start();
        std::copy(first.begin(), first.end(), now.begin());
        MeasureSeries all;
        for (std::size_t frame = 0;; ++frame) {
            for (std::size_t i = 0; i < all[frame].size(); ++i)
                all[frame][i] = static_cast<double>(now[i]);
            if (frame == frames)
                return all;
            for (int part = 0; part < 16; ++part)
                now = extrapolated(now, 1.0L / 16, c);
        }
    }();
    return series;
}

double errorOf(Solver &solver)
{
    MeasureSeries series{};
    solver.run(series);
    double largest = 0.0;
    for (std::size_t frame = 0; frame <= frames; ++frame) {
        for (std::size_t i = 0; i < points; ++i) {
            const double off = std::hypot(series[frame][i] - truth()[frame][i],
                                          series[frame][points + i] - truth()[frame][points + i]);
            largest = std::isfinite(off) ? std::max(largest, off) : HUGE_VAL;
        }
    }
    return largest;
}

/// Returns the shortest time of several runs. It only serves to choose the contender to benchmark.
double roughSeconds(Solver &solver)
{
    MeasureSeries series{};
    double least = HUGE_VAL;
    for (int i = 0; i < 15; ++i) {
        const auto before = std::chrono::steady_clock::now();
        solver.run(series);
        least =
            std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
    }
    return least;
}

/// Returns the errors of a contender at its tolerances. Each contender is measured only once.
const std::vector<double> &errorsOf(const Contender &one)
{
    static std::map<const Contender *, std::vector<double>> known;
    std::vector<double> &errors = known[&one];
    if (errors.empty()) {
        for (const double tolerance : one.tolerances)
            errors.push_back(errorOf(*one.make(tolerance)));
    }
    return errors;
}

Champion choose(const std::string &team, double target)
{
    Champion best;
    double least = HUGE_VAL;
    for (const Contender &one : contenders()) {
        if (one.team != team)
            continue;
        const std::vector<double> &errors = errorsOf(one);
        const auto fits =
            std::find_if(errors.begin(), errors.end(), [&](double error) { return error <= target; });
        if (fits == errors.end())
            continue;
        const double tolerance = one.tolerances[std::size_t(fits - errors.begin())];
        std::unique_ptr<Solver> solver = one.make(tolerance);
        const double seconds = roughSeconds(*solver);
        if (seconds >= least)
            continue;
        least = seconds;
        char figures[80];
        std::snprintf(figures, sizeof figures, " at %.3g: %.2g px off", tolerance, *fits);
        best = {std::move(solver), one.name + figures};
    }
    return best;
}

}

Row<double> start()
{
    Row<double> row{};
    std::uint64_t bits = 88172645463325252u; // Marsaglia's xorshift, for the same start on every machine
    const auto between = [&bits](double low, double high) {
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        return low + (high - low) * static_cast<double>(bits >> 11) * 0x1.0p-53;
    };
    // The feet start around the body. Close to the body's centre, their motion would be chaotic.
    for (std::size_t i = 0; i < points; ++i) {
        const double away = i < feet ? between(35.0, 75.0) : 0.0;
        const double angle = 1.2566370614359172 * static_cast<double>(i) + between(-0.3, 0.3);
        row[i] = 270.0 + away * std::cos(angle);
        row[points + i] = 200.0 + away * std::sin(angle);
    }
    return row;
}

int enter(Contender contender)
{
    contenders().push_back(std::move(contender));
    return 0;
}

std::vector<double> tolerancesDownTo(double finest)
{
    std::vector<double> all;
    for (int i = 0; all.empty() || all.back() > finest; ++i)
        all.push_back(std::pow(10.0, -i / 8.0));
    return all;
}

Champion &champion(const std::string &team, double target)
{
    static std::map<std::pair<std::string, double>, Champion> known;
    const auto [entry, isNew] = known.try_emplace({team, target});
    if (isNew)
        entry->second = choose(team, target);
    return entry->second;
}

}
