#pragma once

#include "lessons/api/checks/exact_run.h"
#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <cstdint>
#include <memory>
#include <vector>

/// The views, measures and overlays of this lesson. All that compare with the exact motion within a step
/// share one ExactRun.
namespace accuracy {

using Exact = std::shared_ptr<lessons::ExactRun>;

/// Returns a view with a small body, so that the motion near it is visible.
lessons::View smallBodyView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view of a ball in its room.
lessons::View ballView(const sim::Values &values);
/// Returns a ballView() that shows the room only if walls act.
lessons::View ballInRoomView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view of the crowd. Its stage grows with the number of creatures.
lessons::View crowdView(const sim::Scene &scene, const sim::Values &values);

/// Returns the kinetic plus the potential energy of a scene with one point, in px^2/frame^2 for mass 1. The
/// potential energy is that of gravity in `bounce`, otherwise that of the spring.
double energyOf(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// Returns by how much the energy of a state exceeds that of the exact run at the same frame, in percent of
/// the latter. NaN without an exact run or if its energy is nearly 0.
double energyDrift(lessons::ExactRun &exact, const sim::Script &script, const sim::Scene &scene,
                   const sim::State &state, const sim::Values &values);
/// Returns the number of force evaluations per frame. `state` is at the end of the frame and `before` at its
/// start. Methods with adaptive steps need `before`; without it the result is NaN.
double forceEvaluations(const sim::Script &script, const sim::State &state, const sim::State *before);

/// Returns the length of the last adaptive step, in frames: the shortest if islands have different steps. NaN
/// without adaptive steps.
double lastStep(const sim::State &state);

/// Returns the largest distance of a point from its exact position, px.
lessons::Measure errorMeasure(const Exact &exact);
/// Returns energyDrift() in percent.
lessons::Measure driftMeasure(const Exact &exact);
/// Returns the length of the last step, frames.
lessons::Measure stepMeasure();
/// Returns the force evaluations per frame.
lessons::Measure forceEvaluationsMeasure();

/// Returns a ring at the exact position of each dynamic point, and a line with the distance from the point
/// that is farthest off.
std::vector<lessons::Overlay> exactOverlays(lessons::ExactRun &exact, const lessons::View &view,
                                            const sim::Script &script, const sim::State &state,
                                            std::int64_t frame);

/// Returns crosses at the centre of the spring of `big_step` and `energy`, and at the two turning points of
/// its foot without damping.
std::vector<lessons::Overlay> turningPoints(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);
/// Returns two rings for `adapt`: the rest length of the spring, and the largest distance of its foot without
/// damping.
std::vector<lessons::Overlay> turningRings(const sim::Scene &scene, const sim::State &state,
                                           const sim::Values &values);

}
