#pragma once

#include "sim/base/step_size.h"
#include "sim/base/vec2.h"
#include "sim/forward.h"
#include "sim/scene/values.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sim {

struct Keys;

/// A hand takes hold of a body.
struct Grab
{
    std::string body;
    friend bool operator==(const Grab &, const Grab &) = default;
};
/// The hand goes to a place, in px.
struct Move
{
    Vec2 to;
    friend bool operator==(const Move &, const Move &) = default;
};
/// The hand lets go.
struct Release
{
    friend bool operator==(const Release &, const Release &) = default;
};
/// The pointer goes to a place, in px, with its button down or up.
struct Pointer
{
    Vec2 at;
    bool down = false;
    friend bool operator==(const Pointer &, const Pointer &) = default;
};
/// What swims gets a new target, in px.
struct Target
{
    Vec2 at;
    friend bool operator==(const Target &, const Target &) = default;
};
/// This frame's turbulence, in degrees, in place of the random one.
struct Gust
{
    double degrees = 0.0;
    friend bool operator==(const Gust &, const Gust &) = default;
};
/// A key that steers goes down or up.
struct Key
{
    bool Keys::*key = nullptr;
    bool down = false;
    friend bool operator==(const Key &, const Key &) = default;
};
/// A parameter takes a new value.
struct Set
{
    std::string parameter;
    double value = 0.0;
    friend bool operator==(const Set &, const Set &) = default;
};

/// What a learner does in the scene.
using Input = std::variant<Grab, Move, Release, Pointer, Target, Gust, Key>;

/// Input from outside, applied before frame `frame` is computed.
struct Event
{
    std::int64_t frame = 0;
    std::variant<Grab, Move, Release, Pointer, Target, Gust, Key, Set> what;
    friend bool operator==(const Event &, const Event &) = default;
};

/// Where a body starts in place of where its scene puts it.
struct BodyStart
{
    Vec2 x;                ///< px
    std::optional<Vec2> v; ///< px/frame
    friend bool operator==(const BodyStart &, const BodyStart &) = default;
};

/// Everything that determines a run: the same script gives the same bits, whatever was done to get there.
struct Script
{
    std::function<Scene(const Values &)> build;
    Values values; ///< at the start
    std::map<std::string, BodyStart> bodies;
    std::vector<std::string> effectsOff; ///< ids of listed effects that do not act
    MethodPtr method;
    StepSize step;
    std::vector<Event> input; ///< by frame; within a frame in the order in which they are applied
};

/// The end of the row whose computation an event of `frame` precedes. Frame 0 is the start: its events come with the first
/// row.
std::int64_t outputStepEnd(std::int64_t frame, int framesPerOutput);

/// The scene of `script` for `values`: built, with its bodies' starts, without the effects that are off.
/// @throws Error "start-not-finite" (body) when a body's start is no place or no velocity; what build() throws
Scene sceneOf(const Script &script, const Values &values);

/// `what` as an event of the row whose computation it precedes.
Event eventOf(std::int64_t frame, const Input &what);

/// Lets no event through that is no place, no angle or no value: one would make all numbers of a run so.
/// @throws Error "input-not-finite" (event, frame) when a number of it is not finite
void checkFinite(const Event &event);

/// Sorts events by frame and keeps the order within each frame.
void sortByFrame(std::vector<Event> &input);

/// The first frame whose computation differs between two inputs, each sorted by frame; the largest number where none does.
std::int64_t firstDifference(const std::vector<Event> &a, const std::vector<Event> &b);

}
