#pragma once

#include "sim/run/timeline.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <variant>

/// Queries of the input of a run.
namespace lessons {

/// Returns the input that has been applied at the cursor, in order of time. Inside a frame, this includes the
/// input of the frame in progress. Empty at the start of the run.
std::span<const sim::Event> appliedInput(const sim::Timeline &timeline);
std::span<const sim::Event> appliedInput(const sim::Track &track);

/// Returns whether the last drag is finished and moved `body` (any if empty).
bool isReleased(const sim::Track &track, const std::string &body);

/// Returns whether input of type `Input` for which `matches(input)` holds has been applied at the cursor.
template <class Input, class Matches>
bool hasApplied(const sim::Timeline &timeline, Matches &&matches)
{
    const std::span<const sim::Event> applied = appliedInput(timeline);
    return std::any_of(applied.begin(), applied.end(), [&](const sim::Event &event) {
        const auto *input = std::get_if<Input>(&event.what);
        return input && matches(*input);
    });
}

/// Returns whether the run has input of type `Input` at `frame` or later, applied or not.
template <class Input>
bool hasInputFrom(const sim::Timeline &timeline, std::int64_t frame)
{
    const std::vector<sim::Event> &input = timeline.script().input;
    return std::any_of(input.begin(), input.end(), [frame](const sim::Event &event) {
        return std::holds_alternative<Input>(event.what) && event.frame >= frame;
    });
}

}
