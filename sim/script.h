#pragma once

#include "sim/pipeline.h"
#include "sim/values.h"

#include <cstdint>
#include <map>
#include <variant>

namespace sim {

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
/// A parameter takes a new value.
struct Set
{
    std::string parameter;
    double value = 0.0;
    friend bool operator==(const Set &, const Set &) = default;
};

/// Input from outside, applied before frame `frame` is computed.
struct Event
{
    std::int64_t frame = 0;
    std::variant<Grab, Move, Release, Set> what;
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

/// The scene of `script` for `values`: built, with its bodies' starts, without the effects that are off.
Scene sceneOf(const Script &script, const Values &values);

/// Sorts events by frame and keeps the order within each frame.
void sortByFrame(std::vector<Event> &input);

}
