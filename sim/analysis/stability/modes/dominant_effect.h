#pragma once

#include "sim/analysis/stability/modes/linearised_scene.h"

#include <Eigen/Core>

namespace sim {

/// The spring, or other effect, that does most in a pattern of motion.
struct DominantEffect
{
    EffectPtr effect; ///< null where no effect pulls in it
    int point = -1;
    int other = -1; ///< the point at its other end; -1 where it pulls to a place
};

/// Whose pull does most against the pattern `rows` (of Linear::rows): along a link, how far its ends go apart times the
/// pull that this makes.
DominantEffect dominantEffectOf(const LinearisedScene &linearised, const Eigen::VectorXcd &rows);

/// The points that go at least half as far as the one that goes farthest, that one first; three at most.
std::vector<int> largestMovers(const LinearisedScene &linearised, const Eigen::VectorXcd &rows);

}
