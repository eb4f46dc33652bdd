#pragma once

#include "sim/run/sleeping/sleep.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace sim {

/// What is kept of a run, so that going back is exact and quick: states at the ends of rows, and the stretches in which
/// it sleeps. Kept states take at most `budget` bytes: when they are full, every second one is dropped.
class KeyframeStore
{
public:
    /// With a budget of 0 only the start is kept.
    KeyframeStore(std::size_t budget, int framesPerOutput)
        : m_budget(budget), m_framesPerOutput(framesPerOutput)
    {
    }

    /// Keeps `state`, at the end of a row, if its turn is now. The start is always kept.
    void store(const State &state);
    /// The frame of the last kept state that is not after `frame`, which is 0 or later.
    std::int64_t lastAtOrBefore(std::int64_t frame) const;
    /// The one at exactly that frame.
    const State &at(std::int64_t frame) const { return *m_kept.at(frame); }

    /// Where a run sleeps, in order. All of them together take no more than the budget, but for the last one.
    void add(Sleep sleep);
    /// The last one that begins at `frame` or before; null if there is none.
    const Sleep *lastSleepAtOrBefore(std::int64_t frame) const;

    /// Forgets all that is at `frame` or after.
    void forget(std::int64_t frame);
    void setBudget(std::size_t budget);
    std::size_t bytes() const { return m_bytes; }
    std::size_t sleepBytes() const { return m_sleepBytes; }
    std::size_t count() const { return m_kept.size(); }

private:
    void thin();
    void dropSleep(std::vector<Sleep>::iterator sleep);

    std::map<std::int64_t, std::shared_ptr<const State>> m_kept; ///< by frame; 0 is never dropped
    std::vector<Sleep> m_sleeps;                                 ///< by frame
    std::size_t m_bytes = 0;
    std::size_t m_sleepBytes = 0;
    std::size_t m_budget;
    int m_framesPerOutput;
    std::int64_t m_spacing = 1; ///< rows between two kept states
};

}
