#include "sim/effects/contacts/room_limits.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

namespace sim {

std::vector<Region> RoomLimits::regions(DirectionRule) const
{
    return {{"sim/effects/contacts/room_limits.h", "room_limits"},
            {"sim/effects/contacts/room_limits.h", "friction"}};
}

int RoomLimits::count(const State &state, PointRange points) const
{
    return countDynamic(state, points);
}

void RoomLimits::enforce(State &state, PointRange points, DirectionRule, double) const
{
    const bool hasPrevious = state.previous.rows() == state.pointCount();
    for (int i = points.first; i < points.end(); ++i) {
        if (!state.isDynamic(i))
            continue;
        const Vec2 x = state.positionOf(i);
        const Vec2 before = hasPrevious ? Vec2{state.previous(i, 0), state.previous(i, 1)} : x;
        state.place(i, keepInside(x, before, m_halfWidth[i], m_room, m_friction));
    }
}

std::vector<LiveValue> RoomLimits::explain(const State &before, const State &after, int point) const
{
    if (before.positionOf(point) == after.positionOf(point))
        return {};
    return {{"x", after.positionOf(point), before.positionOf(point)}};
}

bool RoomLimits::addToDraft(BlueprintDraft &draft) const
{
    draft.addEffect(
        "room",
        {{"left", m_room.left}, {"right", m_room.right}, {"floor", m_room.floor}, {"friction", m_friction}});
    return true;
}

namespace {

constexpr ParameterSpec roomParameters[] = {
    settings::left,
    settings::right,
    settings::floor,
    {
        .id = "friction",
        .name = SIM_TEXT("Friction"),
        .help = SIM_TEXT("How much a wall slows things that slide along it. 0: like ice."),
        .defaultValue = 0.5,
        .min = 0.0,
        .max = 10.0,
        .sliderMin = 0.0,
        .sliderMax = 2.0,
    }};

EffectPtr makeRoom(const Blueprint &blueprint, const Values &values)
{
    return std::make_shared<RoomLimits>(roomOf(values), halfWidths(blueprint), values["friction"]);
}

}

namespace descriptions {
constinit const EffectDescription room = {
    .id = "room",
    .title = SIM_TEXT("room"),
    .kind = EffectKind::contact,
    .purpose =
        SIM_TEXT("Keeps everything between two walls and above a floor, with friction and without bounce."),
    .parameters = roomParameters,
    .make = makeRoom};
}

}
