#pragma once

#include "lessons/api/step.h"

/// What is marked in the scenes of this lesson.
namespace hard_cases {

/// px: the length of two of the sticks in `contradiction`.
constexpr double shortStick = 20.0;

/// Where the spring of `limit` and `long_run` ends, and the two places between which its foot should swing.
std::vector<lessons::Guide> turningPlaces(const sim::Scene &scene, const sim::State &state,
                                          const sim::Values &values);
/// Where the middle of all points was at the start, and how far it is from there.
std::vector<lessons::Guide> middleMarks(const sim::Scene &scene, const sim::State &state,
                                        const sim::Values &values);

}
