#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

/// The views and overlays of this lesson.
namespace single_spring {

/// Returns a view of discs and of the springs that act.
lessons::View discsAndSprings(const sim::Scene &scene, const sim::Values &values);
/// Returns the same with the angle of the foot as the body sees it.
lessons::View discsWithAngle(const sim::Scene &scene, const sim::Values &values);

/// Returns a cross at the centre, and an arrow for the pull that a spring to the centre would have.
std::vector<lessons::Overlay> inactivePull(const sim::Scene &scene, const sim::State &state,
                                           const sim::Values &values);
/// Returns a cross at the centre, if a spring acts.
std::vector<lessons::Overlay> centreCross(const sim::Scene &scene, const sim::State &state,
                                          const sim::Values &values);
/// Returns a cross beside the body at the end of the spring, if it acts.
std::vector<lessons::Overlay> offsetCross(const sim::Scene &scene, const sim::State &state,
                                          const sim::Values &values);
/// Returns a ring at the rest length round the body, dx and dy from body to foot, and the angle, if the
/// spring acts.
std::vector<lessons::Overlay> ringAndAngle(const sim::Scene &scene, const sim::State &state,
                                           const sim::Values &values);

}
