#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <cstdint>
#include <string>

/// Queries of a run at its cursor and of the input up to there. The checks of things to try are built from
/// them. They keep no state.
namespace lessons {

struct DragGesture;

/// Returns the position of the point `name`, in px. NaN if there is none.
sim::Vec2 positionOf(const sim::Timeline &timeline, const std::string &name);
/// Returns the distance between two points, in px.
double distance(const sim::Timeline &timeline, const std::string &a, const std::string &b);
/// Returns the mean position of all points, in px.
sim::Vec2 centreOfPoints(const sim::Timeline &timeline);
/// Returns the sum of the velocities of all points, in px/frame. It is the momentum if all masses are 1.
sim::Vec2 momentum(const sim::Timeline &timeline);
/// Returns whether the centre of all points is off the stage of 540 x 400 px, with a momentum of 2 px/frame or
/// more. Damping would have stopped a throw by then, so the points move on their own.
bool flewOffStage(const sim::Timeline &timeline);

/// px per frame. A point that moves no farther counts as still.
constexpr double stillness = 0.05;
/// Returns whether no point moves more than `stillness` in each of the next two output steps. One step is not
/// enough, because a swinging point stops for a moment where it turns. False inside a frame.
bool isStill(const sim::Timeline &timeline);
/// Does the same for one point, or all if it is -1.
bool staysStill(const sim::Track &track, int point);

/// Returns the frame at which the parameter `id` was set last, up to the cursor. 0 if it was never set.
std::int64_t lastSetFrame(const sim::Timeline &timeline, const std::string &id);
/// Returns the number of frames since the parameter `id` was set last.
std::int64_t framesSinceSet(const sim::Timeline &timeline, const std::string &id);
/// Returns whether the parameter `id` differs from `value` by less than 0.005, half a unit of the last shown
/// decimal.
bool isSetTo(const sim::Timeline &timeline, const std::string &id, double value);

/// Returns the position of the dragged body just before it was grabbed, in px.
sim::Vec2 grabPosition(const sim::Timeline &timeline, const DragGesture &drag);
/// Returns whether the last drag is finished and released `body` (any if empty) at `minSpeed` px/frame or
/// more.
bool wasThrown(const sim::Timeline &timeline, const std::string &body = {}, double minSpeed = 5.0);

/// Returns the last phase that was computed. Null between two frames.
const sim::Phase *lastPhase(const sim::Timeline &timeline);
/// Returns whether a point of the scene's group `group` (any if -1) has moved in the step in progress. False
/// between two frames.
bool hasMoved(const sim::Timeline &timeline, int group = -1);
/// Returns whether a spring has pulled and nothing has moved yet in the step in progress. False between two
/// frames.
bool onlySpringsPulled(const sim::Timeline &timeline);

/// Returns whether the run has a comparison run with a different value of the parameter `id`.
bool differsFromComparison(const sim::Timeline &timeline, const std::string &id);
/// Returns whether the run uses the method `id`.
bool usesMethod(const sim::Timeline &timeline, const std::string &id);

}
