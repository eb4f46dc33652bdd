#include "sim/effects/breeze.h"

#include "sim/effects/slope.h"
#include "sim/free_points.h"

namespace sim {

std::vector<Region> Breeze::regions(Directions) const
{
    return {{"sim/effects/breeze.h", "breeze"}};
}

int Breeze::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void Breeze::add(const State &state, Points movers, double scale, Directions, Eigen::ArrayX2d &into) const
{
    double *sideways = into.data(); // the column of x
    replaceFree(state.inverseMass, movers, sideways, [&](int i) {
        return sideways[i] + scale * (state.inverseMass[i] * pullOn(state, i).pull.x);
    });
}

bool Breeze::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    for (int i = movers.first; i < movers.end(); ++i) {
        if (!state.feels(i))
            continue;
        const double turns = std::cos(state.gait[m_clock] - state.at(i).x / 100) / 100;
        const double slope = -m_air.wind * m_air.gusts * turns * m_width[i] / 10;
        addSlope(into, i, i, {scale * state.inverseMass[i] * slope, 0.0, 0.0, 0.0});
    }
    return true;
}

/// As the clock stands: where it goes on, the wind does work.
std::optional<double> Breeze::energy(const State &state) const
{
    double sum = 0.0;
    for (int i = 0; i < state.points(); ++i) {
        if (!state.feels(i))
            continue;
        const double x = state.at(i).x;
        const double swelling = 100 * m_air.gusts * std::cos(state.gait[m_clock] - x / 100);
        sum -= m_air.wind * m_width[i] / 10 * (x + swelling);
    }
    return sum;
}

std::vector<Live> Breeze::explain(const State &state, int mover, Directions) const
{
    if (!state.feels(mover))
        return {};
    const BreezePull b = pullOn(state, mover);
    return {{"swell", b.swell}, {"pull", state.inverseMass[mover] * b.pull}};
}

}
