#pragma once

#include "sim/script.h"

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

    /// Composes each scene that the script comes to from `frame` on.
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
    mutable std::shared_ptr<const Segment> m_cached; ///< the segment last asked for
    mutable std::int64_t m_cachedFrom = -1;
};

}
