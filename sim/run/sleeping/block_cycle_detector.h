#pragma once

#include "sim/forward.h"

#include <vector>

namespace sim {

/// Which blocks of a large scene have come to rest, while others may still move: those whose points had the same bits
/// at the ends of two neighbouring rows. As a block depends on its own points alone, a row changes nothing in it until
/// a hand touches one of them.
class BlockCycleDetector
{
public:
    /// Compares two states of a run of `pipeline`, one row apart, with no change of parameters between them.
    void check(const Pipeline &pipeline, const State &before, const State &after);
    /// A hand has changed `point`; -1: nothing.
    void wake(const Pipeline &pipeline, int point);
    void wakeAll() { m_asleep.clear(); }
    /// One entry a block, not 0 for those that sleep; empty while all are awake.
    const std::vector<char> &asleep() const { return m_asleep; }

private:
    std::vector<char> m_asleep;
};

}
