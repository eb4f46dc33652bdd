#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/acting.h"
#include "sim/effects/tree/torsion.h"

/// What guides, measures and checks read off a tree.
namespace swaying_tree {

/// How far a branch is from where it grew, in degrees.
double bendOf(const sim::Scene &scene, const sim::State &state, int branch);
/// The largest of them, without its sign.
double largestBend(const sim::Scene &scene, const sim::State &state);

using lessons::effectOf;

/// Where branch `branch` ends, px; where it begins in a scene without joints.
sim::Vec2 endOf(const sim::Scene &scene, const sim::State &state, int branch);
/// The branch whose end is nearest to `place`.
int nearestBranch(const sim::Scene &scene, const sim::State &state, sim::Vec2 place);

lessons::Measure countMeasure();
lessons::Measure bendMeasure();
/// What moves, what the springs hold, and the sum of both.
std::vector<lessons::Measure> energyMeasures();

}
