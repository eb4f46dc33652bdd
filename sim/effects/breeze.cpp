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

std::vector<Live> Breeze::explain(const State &state, int mover, Directions) const
{
    if (!state.feels(mover))
        return {};
    const BreezePull b = pullOn(state, mover);
    return {{"swell", b.swell}, {"pull", state.inverseMass[mover] * b.pull}};
}

}
