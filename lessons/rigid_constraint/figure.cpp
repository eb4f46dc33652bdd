#include "figure.h"

#include "sim/scenes/points.h"

#include <algorithm>
#include <cmath>

namespace rigid_constraint {

namespace {

sim::Scene pointsThat(const sim::Values &values, int own, sim::Inertia inertia)
{
    const auto count = static_cast<std::size_t>(values.points.value_or(own));
    sim::Scene scene = scenes::pointsAt(std::vector<sim::Vec2>(count, {240.0, 165.0}));
    scene.groups.front().inertia = inertia;
    return scene;
}

}

sim::Scene loosePoints(const sim::Values &values, int own)
{
    return pointsThat(values, own, sim::Inertia::none);
}

sim::Scene movingPoints(const sim::Values &values, int own)
{
    return pointsThat(values, own, sim::Inertia::some);
}

void placePoints(sim::Scene &scene, const std::vector<sim::Vec2> &places)
{
    const int count = std::min(scene.start.points(), static_cast<int>(places.size()));
    for (int i = 0; i < count; ++i)
        scene.start.place(i, places[static_cast<std::size_t>(i)]);
}

sim::Stick stickBetween(const std::vector<sim::Vec2> &places, int a, int b)
{
    const sim::Vec2 way = places[static_cast<std::size_t>(b)] - places[static_cast<std::size_t>(a)];
    return {a, b, sim::length(way), 0.5};
}

void addSticks(sim::Scene &scene, const sim::Values &values, const std::vector<sim::Stick> &own,
               int iterations)
{
    scenes::add<sim::Sticks>(scene, values.sticks.value_or(own), scene.start.points(), iterations);
}

std::vector<sim::Stick> sticksOf(const sim::Scene &scene)
{
    std::vector<sim::Stick> all;
    for (const sim::Sticks *sticks : sim::sticksAmong(scene.effects))
        all.insert(all.end(), sticks->list().begin(), sticks->list().end());
    return all;
}

double largestError(const sim::Scene &scene, const sim::State &state)
{
    double largest = 0.0;
    for (const sim::Stick &stick : sticksOf(scene))
        largest = std::max(largest, std::abs(stickError(stick, state)));
    return largest;
}

double largestStretch(const sim::Scene &scene, const sim::State &state)
{
    double largest = 0.0;
    for (const sim::Stick &stick : sticksOf(scene)) {
        if (stick.length > 0.0)
            largest = std::max(largest, 100.0 * std::abs(stickError(stick, state)) / stick.length);
    }
    return largest;
}

Eigen::ArrayXd boxHalfWidths(const sim::Scene &scene)
{
    return Eigen::ArrayXd::Constant(scene.start.points(), jointRadius);
}

Eigen::ArrayXd ragdollHalfWidths(const sim::Scene &scene)
{
    Eigen::ArrayXd half = boxHalfWidths(scene);
    if (half.rows() > 0)
        half[0] = headRadius;
    return half;
}

}
