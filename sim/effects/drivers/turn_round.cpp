#include "sim/effects/drivers/turn_round.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"

namespace sim {

std::vector<Region> TurnRound::regions(Directions) const
{
    return {{"sim/effects/drivers/turn_round.h", "turn_round"}};
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
        const auto turn = [&](int clock) {
            double &speed = state.gaitSpeed[clock];
            speed = turnRound(speed, state.at(i).x, m_half[i], m_room);
        };
        turn(clockOf(i));
        if (m_mates.empty())
            continue;
        for (const int mate : m_mates.at(static_cast<std::size_t>(clockOf(i))))
            turn(mate);
    }
}

std::vector<Live> TurnRound::explain(const State &before, const State &after, int point) const
{
    const int clock = clockOf(point);
    return {{"speed", after.gaitSpeed[clock], before.gaitSpeed[clock]}};
}

bool TurnRound::takeInto(Taken &into) const
{
    into.choose("turn_round", {{"left", m_room.left}, {"right", m_room.right}});
    return true;
}

namespace {

constexpr Setting turnRoundSettings[] = {settings::left, settings::right, settings::floor};

EffectPtr buildTurnRound(const Blueprint &plan, const Values &values)
{
    return std::make_shared<TurnRound>(roomOf(values), halfWidths(plan), clockOf(plan), matesOf(plan));
}

}

namespace described {
constinit const Description turn_round = {
    .id = "turn_round",
    .title = SIM_TEXT("turn round"),
    .kind = Kind::driver,
    .purpose = SIM_TEXT("Makes a creature that meets a wall walk the other way."),
    .settings = turnRoundSettings,
    .make = buildTurnRound};
}

}
