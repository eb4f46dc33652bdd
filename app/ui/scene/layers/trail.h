#pragma once

#include "sim/run/timeline.h"

#include <deque>

namespace app {

/// The positions of the points in the last frames that were shown one after the other. Going back removes
/// frames; a jump removes all. Crowds have no trail.
class Trail
{
public:
    static constexpr std::int64_t length = 20; ///< frames

    struct Mark
    {
        std::int64_t frame = 0;
        Eigen::ArrayX2d position; ///< px, one row per point
    };

    /// Adds or removes positions up to the timeline's cursor.
    void follow(const sim::Timeline &timeline);
    void clear() { m_marks.clear(); }
    const std::deque<Mark> &marks() const { return m_marks; }

private:
    std::deque<Mark> m_marks;
};

}
