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

/// The learner grabs a body.
struct Grab
{
    std::string body;
    friend bool operator==(const Grab &, const Grab &) = default;
};
/// The learner drags the grabbed body to a position (px).
struct Move
{
    Vec2 to;
    friend bool operator==(const Move &, const Move &) = default;
};
/// The learner releases the grabbed body.
struct Release
{
    friend bool operator==(const Release &, const Release &) = default;
};
/// The pointer moves to a position (px) with its button down or up.
struct Pointer
{
    Vec2 at;
    bool down = false;
    friend bool operator==(const Pointer &, const Pointer &) = default;
};
/// Everything that swims gets a new target (px).
struct Target
{
    Vec2 at;
    friend bool operator==(const Target &, const Target &) = default;
};
/// The turbulence of this frame, in degrees, instead of the random one.
struct Gust
{
    double degrees = 0.0;
    friend bool operator==(const Gust &, const Gust &) = default;
};
/// A steering key goes down or up.
struct Key
{
    bool Keys::*key = nullptr;
    bool down = false;
    friend bool operator==(const Key &, const Key &) = default;
};
/// A parameter gets a new value.
struct Set
{
    std::string parameter;
    double value = 0.0;
    friend bool operator==(const Set &, const Set &) = default;
};

/// An input of the learner in the scene.
using Input = std::variant<Grab, Move, Release, Pointer, Target, Gust, Key>;

/// An input that is applied before frame `frame` is computed.
struct Event
{
    std::int64_t frame = 0;
    std::variant<Grab, Move, Release, Pointer, Target, Gust, Key, Set> what;
    friend bool operator==(const Event &, const Event &) = default;
};

/// The initial position and velocity of a body, instead of those of its scene.
struct BodyStart
{
    Vec2 x;                ///< px
    std::optional<Vec2> v; ///< px/frame; empty: as in the scene
    friend bool operator==(const BodyStart &, const BodyStart &) = default;
};

/// Everything that determines a run. The same script always gives the same bits.
struct Script
{
    std::function<Scene(const Values &)> build; ///< builds the scene for given parameter values
    Values values;                              ///< parameters at the start
    std::map<std::string, BodyStart> bodies;    ///< changed initial states, by name of the body
    std::vector<std::string> effectsOff;        ///< ids of effects that are switched off
    MethodPtr method;
    StepSize step;
    std::vector<Event> input; ///< by frame; within a frame in order of application
};

/// Returns the end of the output step whose input includes an event at `frame`. Events at frame 0 belong to
/// the first output step.
std::int64_t outputStepEnd(std::int64_t frame, int framesPerOutput);

/// Returns the scene of `script` for `values`, with the initial states of `script.bodies` and without the
/// effects that are switched off.
/// @throws Error "start-not-finite" (body), and all errors of `script.build`
Scene sceneOf(const Script &script, const Values &values);

/// Returns `what` as an event at `frame`.
Event eventOf(std::int64_t frame, const Input &what);

/// Rejects an event with a number that is not finite, because that number would spread to the whole run.
/// @throws Error "input-not-finite" (event, frame)
void checkFinite(const Event &event);

/// Sorts events by frame and keeps the order within each frame.
void sortByFrame(std::vector<Event> &input);

/// Returns the first frame at which two inputs, each sorted by frame, differ. Returns the largest int64 if
/// they are equal.
std::int64_t firstDifference(const std::vector<Event> &a, const std::vector<Event> &b);

}
