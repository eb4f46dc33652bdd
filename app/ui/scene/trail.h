#pragma once

#include "sim/run/timeline.h"

#include <deque>

namespace app {

/// Where the points were in the last frames that were shown one after the other. Going back takes frames away;
/// a jump takes all. A crowd leaves none.
class Trail
{
public:
    static constexpr std::int64_t length = 20; ///< frames

    struct Mark
    {
        std::int64_t frame = 0;
        Eigen::ArrayX2d position; ///< px, one row per point
    };

    /// Goes on to where the timeline stands.
    void follow(const sim::Timeline &timeline);
    void clear() { m_marks.clear(); }
    const std::deque<Mark> &marks() const { return m_marks; }

private:
    std::deque<Mark> m_marks;
};

}
