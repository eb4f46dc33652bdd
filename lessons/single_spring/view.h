#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

/// How the scenes of this lesson look, and what is drawn over them.
namespace single_spring {

/// Discs, and the springs that act.
lessons::View discsAndSprings(const sim::Scene &scene, const sim::Values &values);

/// The centre, and the pull that a spring to it would have.
std::vector<lessons::Overlay> pullToCome(const sim::Scene &scene, const sim::State &state,
                                         const sim::Values &values);
/// The centre.
std::vector<lessons::Overlay> centreCross(const sim::Scene &scene, const sim::State &state,
                                          const sim::Values &values);
/// The place beside the body where the spring ends.
std::vector<lessons::Overlay> offsetCross(const sim::Scene &scene, const sim::State &state,
                                          const sim::Values &values);
/// The ring of all places at the right distance, the sides of the triangle from body to foot, and its angle.
std::vector<lessons::Overlay> ringAndAngle(const sim::Scene &scene, const sim::State &state,
                                           const sim::Values &values);

}
