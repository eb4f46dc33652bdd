#include "sim/effects/contacts/room_limits.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"

namespace sim {

std::vector<Region> RoomLimits::regions(Directions) const
{
    return {{"sim/effects/contacts/room_limits.h", "room_limits"},
            {"sim/effects/contacts/room_limits.h", "friction"}};
}

int RoomLimits::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void RoomLimits::enforce(State &state, Points points, Directions, double) const
{
    const bool remembers = state.previous.rows() == state.points();
    for (int i = points.first; i < points.end(); ++i) {
        if (!state.feels(i))
            continue;
        const Vec2 x = state.at(i);
        const Vec2 before = remembers ? Vec2{state.previous(i, 0), state.previous(i, 1)} : x;
        state.place(i, keepInside(x, before, m_half[i], m_room, m_friction));
    }
}

std::vector<Live> RoomLimits::explain(const State &before, const State &after, int point) const
{
    if (before.at(point) == after.at(point))
        return {};
    return {{"x", after.at(point), before.at(point)}};
}

bool RoomLimits::takeInto(Taken &into) const
{
    into.choose(
        "room",
        {{"left", m_room.left}, {"right", m_room.right}, {"floor", m_room.floor}, {"friction", m_friction}});
    return true;
}

namespace {

constexpr Setting roomSettings[] = {
    settings::left,
    settings::right,
    settings::floor,
    {
        .id = "friction",
        .name = SIM_TEXT("Friction"),
        .help = SIM_TEXT("How much a wall’s push holds back what slides along it. 0: like ice."),
        .preset = 0.5,
        .min = 0.0,
        .max = 10.0,
        .sliderMin = 0.0,
        .sliderMax = 2.0,
    }};

EffectPtr buildRoom(const Blueprint &plan, const Values &values)
{
    return std::make_shared<RoomLimits>(roomOf(values), halfWidths(plan), values["friction"]);
}

}

namespace described {
constinit const Description room = {
    .id = "room",
    .title = SIM_TEXT("room"),
    .kind = Kind::contact,
    .purpose =
        SIM_TEXT("Keeps everything between two walls and above a floor, with friction and without a bounce."),
    .settings = roomSettings,
    .make = buildRoom};
}

}
