#include "sim/effects/contacts/ramp.h"

#include "sim/scene/built.h"
#include "sim/scene/values.h"
#include "sim/simd/free_points.h"

#include <cmath>
#include <numbers>

namespace sim {

Incline inclineOf(Vec2 through, double angle, double bounce)
{
    const double rad = angle / 180.0 * std::numbers::pi;
    return {through, {-std::sin(rad), -std::cos(rad)}, bounce};
}

std::vector<Region> Ramp::regions(Directions) const
{
    return {{"sim/effects/contacts/ramp.h", "ramp"}, {"sim/effects/contacts/reflection.h", "reflection"}};
}

int Ramp::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

std::vector<Surface> Ramp::surfaces(int point) const
{
    return {{m_edge.normal, dot(m_edge.through, m_edge.normal) + m_half[point], m_edge.bounce, Grip::none}};
}

void Ramp::resolve(State &state, Points points) const
{
    const Columns x(state.position), v(state.velocity);
    replaceFreeMotion(state, points, [=, half = m_half.data(), edge = m_edge](int i) {
        return ramp(x.at(i), v.at(i), half[i], edge);
    });
}

bool Ramp::takeInto(Taken &into) const
{
    const double angle = std::atan2(-m_edge.normal.x, -m_edge.normal.y) * 180.0 / std::numbers::pi;
    into.choose("ramp", {{"ramp", angle},
                         {"ramp_x", m_edge.through.x},
                         {"ramp_y", m_edge.through.y},
                         {"bounce", m_edge.bounce}});
    return true;
}

namespace {

constexpr Setting rampSettings[] = {
    settings::bounce,
    {"ramp", SIM_TEXT("Ramp"), "", SIM_TEXT("°"),
     SIM_TEXT("How steeply it rises to the right. 0: level. 90: a wall on the right. 180: a ceiling."), 20.0,
     -180.0, 180.0, -180.0, 180.0, 0},
    {"ramp_x", SIM_TEXT("Ramp x"), "", SIM_TEXT("px"),
     SIM_TEXT("How far to the right a place of the ramp is."), 270.0, -1e6, 1e6, 0.0, 540.0, 0},
    {"ramp_y", SIM_TEXT("Ramp y"), "", SIM_TEXT("px"), SIM_TEXT("How far down that place is."), 320.0, -1e6,
     1e6, 0.0, 400.0, 0}};

EffectPtr buildRamp(const Blueprint &plan, const Values &values)
{
    const Vec2 through{values["ramp_x"], values["ramp_y"]};
    return std::make_shared<Ramp>(inclineOf(through, values["ramp"], values["bounce"]), halfWidths(plan));
}

}

namespace described {
constinit const Description ramp = {
    .id = "ramp",
    .title = SIM_TEXT("ramp"),
    .kind = Kind::contact,
    .purpose = SIM_TEXT("Keeps everything on one side of a straight line, which leans as you like."),
    .settings = rampSettings,
    .make = buildRamp};
}

}
