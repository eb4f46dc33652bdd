#pragma once

#include "sim/run/track.h"

#include <vector>

namespace sim {

/// What one effect has gathered on all points: px/frame^2, one row per point.
struct ForceSnapshot
{
    EffectPtr effect;
    Eigen::ArrayX2d acceleration;
};

/// The accelerations that the phases done of the step under way have gathered and that no move has spent yet, one
/// entry per effect in the order in which they ran. Empty between two rows.
std::vector<ForceSnapshot> accumulatedForces(const Track &track);
/// What each force of the scene pulls with where things are now, all points at once, one entry per force in the order
/// in which they are listed. Without those that pull nothing.
std::vector<ForceSnapshot> currentForces(const Track &track);

}
