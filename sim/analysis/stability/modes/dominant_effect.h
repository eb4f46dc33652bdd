#pragma once

#include "sim/analysis/stability/modes/linearised_scene.h"

#include <Eigen/Core>

namespace sim {

/// The spring or other effect that does the most work in a mode.
struct DominantEffect
{
    EffectPtr effect; ///< null if no effect does any
    int point = -1;
    int other = -1; ///< the point at its other end; -1 for a spring to a fixed position
};

/// Returns the effect whose restoring force does the most work in the mode `rows` (of LinearisedScene::rows).
/// The work of a spring is the relative displacement of its ends times its force.
DominantEffect dominantEffectOf(const LinearisedScene &linearised, const Eigen::VectorXcd &rows);

/// Returns up to three points that move at least half as far as the one that moves farthest, in descending
/// order.
std::vector<int> largestMovers(const LinearisedScene &linearised, const Eigen::VectorXcd &rows);

}
