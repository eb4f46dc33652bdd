#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <vector>

/// The overlays, notes and measures of this lesson.
namespace swaying_tree {

/// Returns the angle of a branch from its start angle, in degrees. Without springs in the joints it is the short way,
/// at most 180 degrees to either side.
double bendOf(const sim::Scene &scene, const sim::State &state, int branch);
/// Returns the largest absolute bend of a branch, in degrees.
double largestBend(const sim::Scene &scene, const sim::State &state);

/// Returns the end of a branch, in px. In a scene without joints it returns the start of the branch.
sim::Vec2 endOf(const sim::Scene &scene, const sim::State &state, int branch);
/// Returns the branch whose end is nearest to `position`.
int nearestBranch(const sim::Scene &scene, const sim::State &state, sim::Vec2 position);

/// Returns a cross at the end of the trunk by the chosen formula, with its distance from the exact end. The
/// published formula takes 57.3 degrees per radian.
std::vector<lessons::Overlay> trunkEnd(const sim::Scene &scene, const sim::State &state,
                                       const sim::Values &values);

// The next overlays are empty while the button is up.

/// Returns the wind that blows from the pointer.
std::vector<lessons::Overlay> windFromPointer(const sim::Scene &scene, const sim::State &state,
                                              const sim::Values &values);
/// Returns the wind, and the direction of the wind by each of the two formulas at the branch nearest to the
/// pointer.
std::vector<lessons::Overlay> windByBothFormulas(const sim::Scene &scene, const sim::State &state,
                                                 const sim::Values &values);
/// Returns the direction to the pointer by each of the two formulas at the branch nearest to the pointer.
std::vector<lessons::Overlay> aimByBothFormulas(const sim::Scene &scene, const sim::State &state,
                                                const sim::Values &values);
/// Returns the wind, and rings at the front and the end of the gust. The rings stay after the button is up.
std::vector<lessons::Overlay> gustFromPointer(const sim::Scene &scene, const sim::State &state,
                                              const sim::Values &values);

/// Returns a note that explains why bent branches are below the ground. Empty if none is.
QString groundNote(const sim::Track &run);

/// Returns the number of branches.
lessons::Measure countMeasure();
/// Returns largestBend(), degrees.
lessons::Measure bendMeasure();
/// Returns the total, the kinetic and the potential energy. NaN without torsional springs.
std::vector<lessons::Measure> energyMeasures();

}
