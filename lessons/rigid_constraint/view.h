#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

/// How the scenes of this lesson look, and what is measured.
namespace rigid_constraint {

/// The sticks that act in `scene`; none if there are none.
std::vector<sim::Stick> sticksOf(const sim::Scene &scene);
/// The largest error, in px without its sign, and in % of the stick's length (where that is not 0).
double largestError(const sim::Scene &scene, const sim::State &state);
double largestStretch(const sim::Scene &scene, const sim::State &state);

/// Points and sticks; the pointer carries the first point.
lessons::View pointedLook(const sim::Scene &scene, const sim::Values &values);
/// Points and sticks in a room.
lessons::View boxLook(const sim::Scene &scene, const sim::Values &values);
/// The same with flesh on them, and a head. A file's own figure has none.
lessons::View ragdollLook(const sim::Scene &scene, const sim::Values &values);

lessons::Measure errorMeasure();
lessons::Measure stretchMeasure();

}
