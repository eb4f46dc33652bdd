#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

/// How the scenes of this lesson look, and what is marked in them.
namespace hard_cases {

/// px: the length of two of the sticks in `contradiction`.
constexpr double shortStick = 20.0;

/// The three points of `contradiction`, with a line between each two that shows the error of its length.
lessons::View threeSides(const sim::Scene &scene, const sim::Values &values);
/// Any scene of the catalogue, by its names and effects.
lessons::View caseLook(const sim::Scene &scene, const sim::Values &values);

/// Where the spring of `limit` and `long_run` ends, and the two places between which its foot should swing.
std::vector<lessons::Overlay> turningPlaces(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);
/// Where the middle of all points was at the start, and how far it is from there.
std::vector<lessons::Overlay> middleMarks(const sim::Scene &scene, const sim::State &state,
                                          const sim::Values &values);

}
