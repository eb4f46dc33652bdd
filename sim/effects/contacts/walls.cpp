#include "sim/effects/contacts/walls.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/simd/point_kernels.h"

namespace sim {

std::vector<Region> Walls::regions(DirectionRule) const
{
    return {{"sim/effects/contacts/walls.h", "walls"}};
}

int Walls::count(const State &state, PointRange points) const
{
    return countDynamic(state, points);
}

std::vector<Surface> Walls::surfaces(int point) const
{
    const double half = m_halfWidth[point];
    return {{{-1.0, 0.0}, half - m_room.right, m_room.bounce, Traction::none},
            {{1.0, 0.0}, m_room.left + half, m_room.bounce, Traction::none},
            {{0.0, -1.0}, half - m_room.floor, m_room.bounce, Traction::none}};
}

void Walls::resolve(State &state, PointRange points) const
{
    const XyColumns x(state.position), v(state.velocity);
    updateDynamicMotion(state, points, [=, half = m_halfWidth.data(), room = m_room](int i) {
        return walls(x.at(i), v.at(i), half[i], room);
    });
}

Room roomOf(const Values &values)
{
    return {values["left"], values["right"], values["floor"], values["bounce"]};
}

bool Walls::addToDraft(BlueprintDraft &draft) const
{
    draft.addEffect(
        "walls",
        {{"left", m_room.left}, {"right", m_room.right}, {"floor", m_room.floor}, {"bounce", m_room.bounce}});
    return true;
}

namespace {

constexpr ParameterSpec wallsParameters[] = {settings::left, settings::right, settings::floor,
                                             settings::bounce};

EffectPtr makeWalls(const Blueprint &blueprint, const Values &values)
{
    return std::make_shared<Walls>(roomOf(values), halfWidths(blueprint));
}

}

namespace descriptions {
constinit const EffectDescription walls = {
    .id = "walls",
    .title = SIM_TEXT("walls"),
    .kind = EffectKind::contact,
    .purpose =
        SIM_TEXT("Put back points that have gone past a wall or the floor, and reverse their velocity."),
    .parameters = wallsParameters,
    .make = makeWalls};
}

}
