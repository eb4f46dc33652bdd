#pragma once

#include "sim/run/track.h"

#include <vector>

namespace sim {

/// The acceleration that one effect gives to each point.
struct ForceSnapshot
{
    EffectPtr effect;
    Eigen::ArrayX2d acceleration; ///< px/frame^2, one row per point
};

/// Returns what each effect has added to the accelerations in the current step and no phase has consumed yet.
/// There is one entry per effect, in the order of the phases. Effects that give no acceleration are left out.
/// The result is empty between two steps.
std::vector<ForceSnapshot> accumulatedForces(const Track &track);

/// Returns the acceleration that each force of the scene gives to all points in the current state, in scene
/// order. Forces that give no acceleration are left out.
std::vector<ForceSnapshot> currentForces(const Track &track);

}
