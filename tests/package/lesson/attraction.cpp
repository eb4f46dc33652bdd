#include "attraction.h"

#include <cmath>

/// Returns the acceleration (px/frame^2) of a point at `from`. Within 1 px of the planet it stays finite.
/// Source: Newton, "Principia", book 1, proposition 11.
//! [attraction]
static sim::Vec2 attract(sim::Vec2 from, sim::Vec2 planet, double strength)
{
    sim::Vec2 way = planet - from;
    double distance = std::max(sim::length(way), 1.0);
    sim::Vec2 pull = strength / (distance * distance * distance) * way;
    return pull;
}
//! [attraction]

std::vector<sim::Region> Attraction::regions(sim::DirectionRule) const
{
    return {{"lessons/orbit/attraction.cpp", "attraction"}};
}

int Attraction::count(const sim::State &state, sim::PointRange points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void Attraction::add(const sim::State &state, sim::PointRange movers, double scale, sim::DirectionRule,
                     Eigen::ArrayX2d &into) const
{
    for (int point = movers.first; point < movers.end(); ++point) {
        if (!state.isDynamic(point))
            continue;
        const sim::Vec2 pull = attract(state.positionOf(point), m_planet, m_strength);
        into(point, 0) += scale * pull.x;
        into(point, 1) += scale * pull.y;
    }
}

/// The potential energy is 0 infinitely far away.
std::optional<double> Attraction::potentialEnergy(const sim::State &state) const
{
    double sum = 0.0;
    for (int point = 0; point < state.pointCount(); ++point) {
        if (state.isDynamic(point))
            sum -= m_strength / sim::length(m_planet - state.positionOf(point)) / state.inverseMass[point];
    }
    return sum;
}

std::vector<sim::LiveValue> Attraction::explain(const sim::State &state, int mover, sim::DirectionRule) const
{
    if (!state.isDynamic(mover))
        return {};
    return {{"pull", attract(state.positionOf(mover), m_planet, m_strength)}};
}

constinit const sim::EffectDescription attractionDescription = {
    .id = "attraction",
    .title = SIM_TEXT("attraction"),
    .kind = sim::EffectKind::gravity,
    .purpose = SIM_TEXT("Pulls a moon to its planet, four times as hard at half the distance."),
};
