#pragma once

#include "sim/forward.h"

#include <vector>

namespace sim {

/// Detects the cache blocks of a large scene that repeat exactly while others still move. A block sleeps if
/// its points had the same bits at the ends of two consecutive output steps. A block depends only on its own
/// points, so it stays the same until the learner drags one of them.
class BlockCycleDetector
{
public:
    /// Compares two states of `pipeline`, one output step apart, with no change of parameters between them.
    void check(const Pipeline &pipeline, const State &before, const State &after);
    /// Wakes the cache block of `point`, which the learner drags. Does nothing if `point` is -1.
    void wake(const Pipeline &pipeline, int point);
    void wakeAll() { m_asleep.clear(); }
    /// Returns one entry per cache block: not 0 if it sleeps. Empty if all blocks are awake.
    const std::vector<char> &asleep() const { return m_asleep; }

private:
    std::vector<char> m_asleep;
};

}
