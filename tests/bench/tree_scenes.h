#pragma once

#include "sim/effects/tree/tree_wind.h"
#include "sim/scene/scene.h"

/// Full trees, in which every branch but the twigs has two children, with the numbers of the lesson swaying_tree.
namespace bench::trees {

constexpr double ease = 8.0;        ///< frames, of the return to rest
constexpr double wind = 5.0;        ///< the wind's strength
constexpr double turbulence = 20.0; ///< degrees
constexpr std::uint64_t seed = 1;
constexpr sim::Vec2 foot = {275.0, 400.0};   ///< px, where the trunk begins
constexpr sim::Vec2 pointer = {60.0, 200.0}; ///< px, where the wind comes from

/// 2^(forks + 1) - 1 branches: 30 degrees to either side of their parent, 0.9 times as long.
sim::TreePtr full(int forks);

/// The tutorial's last step with the wind blowing: every branch returns to rest and bends, in every frame.
sim::Scene inTheWind(const sim::TreePtr &tree, sim::TreeFormula formula);
/// Joints that really swing in gusts.
sim::Scene thatSwings(const sim::TreePtr &tree);

}
