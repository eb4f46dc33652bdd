#pragma once

#include "sim/run/sleeping/sleep.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace sim {

/// The keyframes of a run (states at the ends of output steps) and its sleeps, which make seeking back exact
/// and fast. The keyframes take at most `budget` bytes. If they exceed it, every second one is dropped.
class KeyframeStore
{
public:
    /// With a budget of 0, only the initial state is kept.
    KeyframeStore(std::size_t budget, int framesPerOutput)
        : m_budget(budget), m_framesPerOutput(framesPerOutput)
    {
    }

    /// Keeps `state`, the end of an output step, if the current spacing selects it. The initial state is
    /// always kept.
    void store(const State &state);
    /// Returns the frame of the last keyframe at or before `frame` (0 or later).
    std::int64_t lastAtOrBefore(std::int64_t frame) const;
    /// Returns the keyframe at exactly `frame`, which must exist.
    const State &at(std::int64_t frame) const { return *m_keyframes.at(frame); }

    /// Adds a sleep. If all sleeps together exceed the budget, the earliest are dropped, but never the last
    /// one.
    void add(Sleep sleep);
    /// Returns the last sleep that begins at or before `frame`, or null.
    const Sleep *lastSleepAtOrBefore(std::int64_t frame) const;

    /// Drops the keyframes at or after `frame` (1 or later) and the sleeps that begin there.
    void forget(std::int64_t frame);
    /// Limits the keyframes to `budget` bytes from now on, and the sleeps to as many.
    void setBudget(std::size_t budget);
    /// Returns the memory of the keyframes, in bytes.
    std::size_t bytes() const { return m_bytes; }
    std::size_t sleepBytes() const { return m_sleepBytes; }
    /// Returns the number of keyframes.
    std::size_t count() const { return m_keyframes.size(); }

private:
    /// Drops keyframes and sleeps until they are within the budget.
    void dropExcess();
    void dropSleep(std::vector<Sleep>::iterator sleep);

    std::map<std::int64_t, std::shared_ptr<const State>> m_keyframes; ///< by frame; 0 is never dropped
    std::vector<Sleep> m_sleeps;                                      ///< in order of from()
    std::size_t m_bytes = 0;
    std::size_t m_sleepBytes = 0;
    std::size_t m_budget;
    int m_framesPerOutput;
    std::int64_t m_spacing = 1; ///< output steps between two keyframes
};

}
