#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// A race: a body and five feet in the air, without gravity or walls, over 200 frames. All contenders compute
/// the positions at whole frames. Each uses the coarsest tolerance that meets the target error.
namespace bench::air {

constexpr int feet = 5, points = feet + 1, frames = 200;
constexpr double k = 0.2, radius = 50.0, damp = 0.97;

/// The target errors, px.
inline constexpr std::array errors = {1e-2, 1e-4, 1e-6, 1e-8};
/// The teams, ours first.
inline constexpr std::array teams = {"springstep", "odeint", "cvode"};
/// Returns the name of the benchmark in which `team` meets `error` px: "odeint_1e-2".
inline std::string nameOf(const std::string &team, double error)
{
    return team + "_1e" + std::to_string(std::lround(std::log10(error)));
}

/// x of all points, then y (px), then the velocities in the same order. The body is the last point.
template <class Number>
using Row = std::array<Number, 4 * points>;
/// x of all points, then y, at each whole frame.
using MeasureSeries = std::array<std::array<double, 2 * points>, frames + 1>;

Row<double> start();

/// Computes the right-hand side as hand-written code; c = -ln(damp).
template <class Number>
void rates(const Row<Number> &now, Row<Number> &change, Number c)
{
    constexpr int body = feet, y = points, v = 2 * points;
    Number pullX = 0, pullY = 0;
    for (int i = 0; i < 2 * points; ++i)
        change[std::size_t(i)] = now[std::size_t(v + i)];
    for (int i = 0; i < feet; ++i) {
        const Number dx = now[std::size_t(i)] - now[body], dy = now[std::size_t(y + i)] - now[y + body];
        const Number share = Number(k) * (Number(radius) / std::sqrt(dx * dx + dy * dy) - 1);
        change[std::size_t(v + i)] = share * dx - c * now[std::size_t(v + i)];
        change[std::size_t(v + y + i)] = share * dy - c * now[std::size_t(v + y + i)];
        pullX += share * dx;
        pullY += share * dy;
    }
    change[v + body] = -pullX - c * now[v + body];
    change[v + y + body] = -pullY - c * now[v + y + body];
}

/// A contender, set up for one tolerance.
class Solver
{
public:
    virtual ~Solver() = default;
    /// Runs from the start, and writes the positions to `series`.
    virtual void run(MeasureSeries &series) = 0;
};

struct Contender
{
    std::string team;
    std::string name;
    std::vector<double> tolerances; ///< from coarse to fine; step sizes for methods with a fixed step
    std::function<std::unique_ptr<Solver>(double)> make;
};

/// Enters a contender into the race.
int enter(Contender contender);

/// Returns tolerances from 1 down to `finest`, eight per decade.
std::vector<double> tolerancesDownTo(double finest);

/// The fastest contender of a team whose error is at most `target` px, ready to run; null if there is none.
struct Champion
{
    std::unique_ptr<Solver> solver;
    std::string name; ///< with its tolerance and error
};
Champion &champion(const std::string &team, double target);

}
