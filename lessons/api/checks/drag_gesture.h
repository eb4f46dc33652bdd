#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lessons {

/// Where the hand went in one frame.
struct HandPlace
{
    std::int64_t frame = 0; ///< the frame whose computation it precedes
    sim::Vec2 at;           ///< px
};

/// One time that a hand held a body, from the grab to the moment it let go.
struct Carry
{
    std::string body;
    std::int64_t grabbed = 0;          ///< the frame whose computation the grab precedes
    std::optional<std::int64_t> letGo; ///< likewise; empty while the hand still holds
    std::vector<HandPlace> path;       ///< at most one a frame; empty if the hand never moved

    /// The farthest that the hand came from where it first moved to, in px.
    double reach() const;
    /// The velocity that the body had when the hand let go, in px/frame; 0 while it is held.
    sim::Vec2 throwVelocity() const;

private:
    std::optional<sim::Vec2> handAt(std::int64_t frame) const;
};

/// What the hand did up to the cursor, in order.
std::vector<Carry> carries(const sim::Timeline &timeline);

/// The last carry, if the hand has let go since and, with a name given, it was that body.
std::optional<Carry> lastLetGo(const sim::Timeline &timeline, const std::string &body = {});

/// The body in the hand at the cursor; empty if there is none.
std::string heldBody(const sim::Timeline &timeline);

/// How many frames the hand has done nothing, up to the cursor.
std::int64_t framesWithoutHand(const sim::Timeline &timeline);

}
