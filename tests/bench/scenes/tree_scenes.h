#pragma once

#include "sim/effects/tree/tree_wind.h"
#include "sim/scene/scene.h"

/// Full trees, in which every branch but the twigs has two children, with the numbers of the lesson swaying_tree.
namespace bench::trees {

constexpr double ease = 8.0;        ///< frames, time constant of the return to rest
constexpr double wind = 5.0;        ///< the wind's strength
constexpr double turbulence = 20.0; ///< degrees
constexpr std::uint64_t seed = 1;
constexpr sim::Vec2 foot = {275.0, 400.0};   ///< px, the start of the trunk
constexpr sim::Vec2 pointer = {60.0, 200.0}; ///< px, the source of the wind

/// Returns a tree of 2^(forks + 1) - 1 branches: 30 degrees to either side of their parent, 0.9 times as
/// long.
sim::TreePtr full(int forks);

/// Returns the tutorial's last step in the wind: every branch bends and returns to rest, in every frame.
sim::Scene inTheWind(const sim::TreePtr &tree, sim::TreeFormula formula);
/// Returns a tree with spring joints that swing in gusts.
sim::Scene thatSwings(const sim::TreePtr &tree);

}
