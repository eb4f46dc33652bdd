#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

/// The views and measures of this lesson.
namespace rigid_constraint {

/// Returns the sticks that act in `scene`.
std::vector<sim::Stick> sticksOf(const sim::Scene &scene);
/// Returns the largest absolute error of a stick, in px.
double largestError(const sim::Scene &scene, const sim::State &state);
/// Returns the largest absolute error of a stick in % of its length. Sticks of length 0 are ignored.
double largestStretch(const sim::Scene &scene, const sim::State &state);

/// Returns a view of points and sticks. Point 0 follows the pointer.
lessons::View pointerView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view of points and sticks in a room.
lessons::View boxView(const sim::Scene &scene, const sim::Values &values);
/// Returns a boxView() with limbs and a head. A figure from a file has neither.
lessons::View ragdollView(const sim::Scene &scene, const sim::Values &values);

lessons::Measure errorMeasure();
lessons::Measure stretchMeasure();

}
