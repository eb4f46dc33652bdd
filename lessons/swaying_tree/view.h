#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <vector>

/// How the scenes of this lesson look, what is drawn over them, and what is measured.
namespace swaying_tree {

/// How far a branch is from where it grew, in degrees.
double bendOf(const sim::Scene &scene, const sim::State &state, int branch);
/// The largest of them, without its sign.
double largestBend(const sim::Scene &scene, const sim::State &state);

/// Where branch `branch` ends, px; where it begins in a scene without joints.
sim::Vec2 endOf(const sim::Scene &scene, const sim::State &state, int branch);
/// The branch whose end is nearest to `place`.
int nearestBranch(const sim::Scene &scene, const sim::State &state, sim::Vec2 place);

/// How far off the trunk's end is with the published 57.3 degrees to the radian.
std::vector<lessons::Overlay> trunkEnd(const sim::Scene &scene, const sim::State &state,
                                       const sim::Values &values);

/// These three draw nothing while the button is up. Wind that blows from the pointer:
std::vector<lessons::Overlay> windFromPointer(const sim::Scene &scene, const sim::State &state,
                                              const sim::Values &values);
/// The same, and for the branch nearest to the pointer where each of the two formulas wants it to turn.
std::vector<lessons::Overlay> windByBothFormulas(const sim::Scene &scene, const sim::State &state,
                                                 const sim::Values &values);
/// For that branch, where each of the two formulas turns it to find the pointer.
std::vector<lessons::Overlay> aimByBothFormulas(const sim::Scene &scene, const sim::State &state,
                                                const sim::Values &values);
/// The wind, and how far its front and its end have come.
std::vector<lessons::Overlay> gustFromPointer(const sim::Scene &scene, const sim::State &state,
                                              const sim::Values &values);

/// Returns why branches are below the ground, while bent ones are; else nothing.
QString noteOfGround(const sim::Track &run);

lessons::Measure countMeasure();
lessons::Measure bendMeasure();
/// What moves, what the springs hold, and the sum of both.
std::vector<lessons::Measure> energyMeasures();

}
