#include "sim/effects/drivers/turn_round.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

namespace sim {

std::vector<Region> TurnRound::regions(DirectionRule) const
{
    return {{"sim/effects/drivers/turn_round.h", "turn_round"}};
}

int TurnRound::count(const State &state, PointRange points) const
{
    return countDynamic(state, points);
}

void TurnRound::drive(State &state, double) const
{
    for (int i = 0; i < state.pointCount(); ++i) {
        if (!state.isDynamic(i))
            continue;
        const auto turn = [&](int clock) {
            double &speed = state.gaitSpeed[clock];
            speed = turnRound(speed, state.positionOf(i).x, m_halfWidth[i], m_room);
        };
        turn(clockOf(i));
        if (m_partnerClocks.empty())
            continue;
        for (const int partner : m_partnerClocks.at(static_cast<std::size_t>(clockOf(i))))
            turn(partner);
    }
}

std::vector<LiveValue> TurnRound::explain(const State &before, const State &after, int point) const
{
    const int clock = clockOf(point);
    return {{"speed", after.gaitSpeed[clock], before.gaitSpeed[clock]}};
}

bool TurnRound::addToDraft(BlueprintDraft &draft) const
{
    draft.addEffect("turn_round", {{"left", m_room.left}, {"right", m_room.right}});
    return true;
}

namespace {

constexpr ParameterSpec turnRoundParameters[] = {settings::left, settings::right, settings::floor};

EffectPtr makeTurnRound(const Blueprint &blueprint, const Values &values)
{
    return std::make_shared<TurnRound>(roomOf(values), halfWidths(blueprint), clockOf(blueprint),
                                       partnerClocksOf(blueprint));
}

}

namespace descriptions {
constinit const EffectDescription turn_round = {
    .id = "turn_round",
    .title = SIM_TEXT("turn round"),
    .kind = EffectKind::driver,
    .purpose = SIM_TEXT("Makes a creature turn round when it meets a wall."),
    .parameters = turnRoundParameters,
    .make = makeTurnRound};
}

}
