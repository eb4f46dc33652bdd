#pragma once

#include "lessons/api/checks/exact_run.h"
#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <cstdint>
#include <memory>
#include <vector>

/// How the scenes of this lesson look, what is measured, and the marks of the exact motion. Those of one step share one
/// ExactRun.
namespace accuracy {

using Exact = std::shared_ptr<lessons::ExactRun>;

/// A creature whose body is a small joint.
lessons::View smallMiddle(const sim::Scene &scene, const sim::Values &values);
/// A ball in its room; the second without the room where no walls act.
lessons::View ballLook(const sim::Values &values);
lessons::View ballInRoom(const sim::Scene &scene, const sim::Values &values);
/// The picture grows with the crowd.
lessons::View crowdInRoom(const sim::Scene &scene, const sim::Values &values);

/// Of what moves and what the springs (and gravity) hold, in px^2/frame^2, with masses of 1; NaN for a scene that
/// is none of this lesson's with one point.
double energyOf(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// How much more energy a state has than the exact run at the same frame, in percent of that; NaN where there is
/// none to speak of.
double energyDrift(lessons::ExactRun &exact, const sim::Script &script, const sim::Scene &scene,
                   const sim::State &state, const sim::Values &values);
/// How often a frame computes all forces, for `state` at its end and `before` at its start; NaN without that where
/// the method chooses.
double computations(const sim::Script &script, const sim::State &state, const sim::State *before);

/// The length of the last step of a method that chooses it, in frames: the shortest, where parts of the scene have their
/// own; NaN where it has taken none.
double lastStep(const sim::State &state);

lessons::Measure offMeasure(const Exact &exact);
lessons::Measure driftMeasure(const Exact &exact);
lessons::Measure stepMeasure();
lessons::Measure computationsMeasure();

/// Where everything should be: a ring for each point that moves by itself, and a line from the one that is farthest
/// off, with its distance.
std::vector<lessons::Overlay> exactMarks(lessons::ExactRun &exact, const lessons::View &look,
                                         const sim::Script &script, const sim::State &state,
                                         std::int64_t frame);

/// Where the spring of the first two steps ends, and the two places between which its foot swings without damping.
std::vector<lessons::Overlay> turningPlaces(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);
/// Where the spring of `adapt` has its length, and how far out its foot comes without damping.
std::vector<lessons::Overlay> turningRings(const sim::Scene &scene, const sim::State &state,
                                           const sim::Values &values);

}
