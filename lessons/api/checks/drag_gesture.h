#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lessons {

/// Where the hand went in one frame.
struct PointerSample
{
    std::int64_t frame = 0; ///< the frame whose computation it precedes
    sim::Vec2 position;     ///< px
};

/// One time that a hand held a body, from the grab to the moment it let go.
struct DragGesture
{
    std::string body;
    std::int64_t grabFrame = 0;               ///< the frame whose computation the grab precedes
    std::optional<std::int64_t> releaseFrame; ///< likewise; empty while the hand still holds
    std::vector<PointerSample> path;          ///< at most one a frame; empty if the hand never moved

    /// The farthest that the hand came from where it first moved to, in px.
    double farthest() const;
    /// The velocity that the body had when the hand let go, in px/frame; 0 while it is held.
    sim::Vec2 releaseVelocity() const;

private:
    std::optional<sim::Vec2> positionAt(std::int64_t frame) const;
};

/// What the hand did up to the cursor, in order.
std::vector<DragGesture> dragGestures(const sim::Timeline &timeline);

/// The last carry, if the hand has let go since and, with a name given, it was that body.
std::optional<DragGesture> lastReleased(const sim::Timeline &timeline, const std::string &body = {});

/// The body in the hand at the cursor; empty if there is none.
std::string heldBody(const sim::Timeline &timeline);

/// How many frames the hand has done nothing, up to the cursor.
std::int64_t idleFrames(const sim::Timeline &timeline);

}
