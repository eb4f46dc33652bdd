#pragma once

#include "lessons/api/view/look.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <vector>

namespace swaying_tree {

/// How far off the trunk's end is with the published 57.3 degrees to the radian.
std::vector<lessons::Guide> trunkEnd(const sim::Scene &scene, const sim::State &state,
                                     const sim::Values &values);

/// These three draw nothing while the button is up. Wind that blows from the pointer:
std::vector<lessons::Guide> windFromPointer(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);
/// The same, and for the branch nearest to the pointer where each of the two formulas wants it to turn.
std::vector<lessons::Guide> windByBothFormulas(const sim::Scene &scene, const sim::State &state,
                                               const sim::Values &values);
/// For that branch, where each of the two formulas turns it to find the pointer.
std::vector<lessons::Guide> aimByBothFormulas(const sim::Scene &scene, const sim::State &state,
                                              const sim::Values &values);
/// The wind, and how far its front and its end have come.
std::vector<lessons::Guide> gustFromPointer(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);

/// Returns why branches are below the ground, while bent ones are; else nothing.
QString noteOfGround(const sim::Track &run);

}
