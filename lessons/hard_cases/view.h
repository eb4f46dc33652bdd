#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

/// The views and overlays of this lesson.
namespace hard_cases {

/// px, length of two of the sticks in `contradiction`.
constexpr double shortStick = 20.0;

/// Returns a view of the triangle in `contradiction`. The colour of each side shows the error of its length.
lessons::View triangleView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view of a scene of the catalogue. It is derived from the names of the points and the effects.
lessons::View caseView(const sim::Scene &scene, const sim::Values &values);

/// Returns crosses at the centre of the spring of `limit` and `long_run`, and at the two points between which
/// the foot should swing.
std::vector<lessons::Overlay> turningPoints(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);
/// Returns a cross at the start of the centre of all points, and a line from there to the centre now.
std::vector<lessons::Overlay> centreOverlays(const sim::Scene &scene, const sim::State &state,
                                             const sim::Values &values);

}
