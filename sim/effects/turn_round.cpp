#include "sim/effects/turn_round.h"

namespace sim {

std::vector<Region> TurnRound::regions(Directions) const
{
    return {{"sim/effects/turn_round.h", "turn_round"}};
}

int TurnRound::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void TurnRound::drive(State &state, double) const
{
    for (int i = 0; i < state.points(); ++i) {
        if (!state.feels(i))
            continue;
        double &speed = state.gaitSpeed[clockOf(i)];
        speed = turnRound(speed, state.at(i).x, m_half[i], m_room);
    }
}

std::vector<Live> TurnRound::explain(const State &before, const State &after, int point) const
{
    const int clock = clockOf(point);
    return {{"speed", after.gaitSpeed[clock], before.gaitSpeed[clock]}};
}

}
