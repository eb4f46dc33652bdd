#pragma once

#include "sim/script.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace sim {

/// A stretch of a run in which no parameter changes: the scene, composed.
struct Segment
{
    Values values;
    Scene scene;
    Pipeline pipeline;
};

/// The stretches of a run, each composed when it is asked for.
class Segments
{
public:
    Segments() = default;
    explicit Segments(const Script &script);

    /// Those of `script`, which differs from the one before in its input alone. What stays as it was is not composed
    /// again.
    void replace(const Script &script);
    /// Composes each scene that the script comes to from `frame` on. The last ones are at hand from then on.
    /// @throws Error when one does not fit its method
    void check(const Script &script, std::int64_t frame) const;
    /// The segment of the row that ends at `rowEnd`. `script` is the one that these are of.
    std::shared_ptr<const Segment> at(const Script &script, std::int64_t rowEnd) const;

private:
    struct Change
    {
        std::int64_t frame;
        Values values;
    };
    std::vector<Change>
        m_changes; ///< values in force from a row's end on, by frame; the first is the start's
    struct Composed
    {
        std::int64_t from = -1; ///< frame of its change
        std::shared_ptr<const Segment> segment;
    };
    /// The segments last asked for, the latest first: those before and after a change are asked for in turn.
    mutable std::array<Composed, 2> m_composed;
};

}
