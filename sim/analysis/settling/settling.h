#pragma once

#include "sim/analysis/stability/growth_map.h"
#include "sim/forward.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// When a run comes to rest, counted from its last input.
///
/// A run rests from a frame on if every point stays within `nearRest` of its place at the end, and moves less than
/// `slowest` in each frame after it. For branches of a tree, both are in degrees. The end is twice as far
/// away as the last frame that counts, so a run that settles has rested for at least `mostFrames`.
struct Settling
{
    enum class Kind {
        settles,
        moves, ///< it does not rest within `mostFrames`
        grows, ///< its motion gets larger and larger
        fails, ///< the method cannot compute it
    };
    Kind kind = Kind::settles;
    std::int64_t frames = 0; ///< until it rests; `settles` only

    static constexpr std::int64_t mostFrames = 600;
    static constexpr double nearRest = 1.0; ///< px, degrees
    static constexpr double slowest = 0.05; ///< px/frame, degrees/frame
    friend bool operator==(const Settling &, const Settling &) = default;
};

/// Returns the frame of the last input of `script`, from which the frames of a Settling are counted; 0 without input.
std::int64_t lastInputFrame(const Script &script);

/// Computes when the run of `script` comes to rest. Returns nothing if it was cancelled.
/// @throws Error if the method cannot compute the scene
std::optional<Settling> settlingOf(const Script &script, const ShouldContinue &shouldContinue);

/// When a run comes to rest, over a plane of two of its parameters.
struct SettlingMap
{
    MapAxis x;
    MapAxis y;
    std::vector<std::optional<Settling>> cells; ///< by rows of y; empty where it is not known
    std::size_t stride = 0; ///< the whole grid with this many cells from place to place is known; 0: none

    std::size_t indexOf(std::size_t column, std::size_t row) const { return row * x.values.size() + column; }
    /// Returns the index of the nearest known cell on the finest grid that knows one; empty if there is none.
    std::optional<std::size_t> nearestKnown(std::size_t column, std::size_t row) const;
};

/// Called after each cell. Returns false to stop.
using SettlingProgress = std::function<bool(const SettlingMap &soFar)>;

/// Returns the script whose runs a map compares: `script` without later changes of the two parameters, and without
/// input after the frame `mostInput`.
Script settlingScript(Script script, const std::string &x, const std::string &y, std::int64_t mostInput);

/// Computes settlingOf() for each pair of values, from a coarse grid to the finest. A cell that cannot be set up stays
/// empty.
SettlingMap settlingMap(const Script &script, MapAxis x, MapAxis y, const SettlingProgress &progress,
                        const ShouldContinue &shouldContinue);

}
