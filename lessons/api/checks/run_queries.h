#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <cstdint>
#include <string>

/// What the checks of "things to try" are made of. Each looks at the moment of the cursor, and at what was done up
/// to there; none of them remembers anything.
namespace lessons {

struct DragGesture;

/// Where the body called `name` is, in px; NaN when there is none.
sim::Vec2 positionOf(const sim::Timeline &timeline, const std::string &name);
/// How far apart two bodies are, in px.
double distance(const sim::Timeline &timeline, const std::string &a, const std::string &b);
/// The middle of all points, in px, and the sum of their velocities, in px/frame: the momentum, with masses of 1.
sim::Vec2 centreOfPoints(const sim::Timeline &timeline);
sim::Vec2 momentum(const sim::Timeline &timeline);
/// Whether a place is on the stage of 540 x 400 px.
bool onStage(sim::Vec2 place);

/// Whether nothing moves: over the next two frames no point would come `stillness` px far in either. (One frame
/// is not enough: what swings stops for a moment where it turns.) Only between frames.
constexpr double stillness = 0.05;
bool isStill(const sim::Timeline &timeline);

/// The frame before which the parameter `id` was set last, up to the cursor; 0 where it never was.
std::int64_t lastSetFrame(const sim::Timeline &timeline, const std::string &id);
/// How many frames the parameter `id` has had the value that it has at the cursor.
std::int64_t framesSinceSet(const sim::Timeline &timeline, const std::string &id);
/// Whether `id` is `value`, to half of what its last shown place can be (0.005).
bool isSetTo(const sim::Timeline &timeline, const std::string &id, double value);

/// Where the body of a carry was when the hand took it, in px.
sim::Vec2 grabPosition(const sim::Timeline &timeline, const DragGesture &carry);
/// Whether the hand let go of `body` (of anything, if empty) while it moved at least `leastSpeed` px/frame.
bool wasThrown(const sim::Timeline &timeline, const std::string &body = {}, double leastSpeed = 5.0);

/// The phase that was done last, inside a frame; null between two frames.
const sim::Phase *lastPhase(const sim::Timeline &timeline);
/// Whether a point of the scene's group `group` (any, if -1) has moved in the step under way, inside a frame.
bool hasMoved(const sim::Timeline &timeline, int group = -1);
/// Whether the cursor stands inside a frame where a spring has pulled and nothing has moved.
bool onlySpringsPulled(const sim::Timeline &timeline);

/// Whether the run has a ghost, which has another value of `id` now.
bool differsFromComparison(const sim::Timeline &timeline, const std::string &id);
/// Whether the run goes on with the method called `id`.
bool usesMethod(const sim::Timeline &timeline, const std::string &id);

}
