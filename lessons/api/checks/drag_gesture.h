#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lessons {

/// The pointer's position in one frame of a drag.
struct PointerSample
{
    std::int64_t frame = 0; ///< the sample is applied before this frame is computed
    sim::Vec2 position;     ///< px
};

/// A drag of a body, from its grab to its release.
struct DragGesture
{
    std::string body;
    std::int64_t grabFrame = 0;               ///< the grab is applied before this frame is computed
    std::optional<std::int64_t> releaseFrame; ///< likewise; empty during the drag
    std::vector<PointerSample> path;          ///< at most one sample per frame; empty without a move

    /// Returns the largest distance of the path from its first sample, in px.
    double farthest() const;
    /// Returns the velocity of the body at its release, in px/frame. It is 0 during the drag and after a drag
    /// whose path began less than two frames before the release.
    sim::Vec2 releaseVelocity() const;

private:
    std::optional<sim::Vec2> positionAt(std::int64_t frame) const;
};

/// Returns the drags up to the cursor, in order of time.
std::vector<DragGesture> dragGestures(const sim::Timeline &timeline);

/// Returns the last drag if it is finished and moved `body` (any body if empty).
std::optional<DragGesture> lastReleased(const sim::Timeline &timeline, const std::string &body = {});

/// Returns the name of the body that is dragged at the cursor. Empty if there is none.
std::string heldBody(const sim::Timeline &timeline);

/// Returns the number of frames up to the cursor since the last input other than a parameter. 0 during a
/// drag.
std::int64_t idleFrames(const sim::Timeline &timeline);

}
