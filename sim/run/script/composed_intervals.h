#pragma once

#include "sim/run/script/script.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace sim {

/// The composed intervals of a run. Each is composed on demand. The last two results are cached and used
/// again for intervals with the same values.
class ComposedIntervals
{
public:
    ComposedIntervals() = default;
    explicit ComposedIntervals(const Script &script);

    /// Replaces the script by `script`, which differs in its input only. Cached intervals that stay the same
    /// are not composed again.
    void replace(const Script &script);
    /// Composes each scene that the input produces from `frame` on, and leaves the last one in the cache.
    /// @throws Error if the method cannot compute one of them
    void check(const Script &script, std::int64_t frame) const;
    /// Returns the interval of the output step that ends at `outputEnd`. `script`: as last given to the
    /// constructor or replace().
    std::shared_ptr<const ComposedInterval> at(const Script &script, std::int64_t outputEnd) const;
    /// Returns whether no parameter is set between the output steps that end at `firstEnd` and `secondEnd`.
    bool areInSameInterval(std::int64_t firstEnd, std::int64_t secondEnd) const;

private:
    /// A change of parameters.
    struct Change
    {
        std::int64_t frame = 0; ///< end of the output step in which it happens
        std::size_t end = 0;    ///< index after the last input event that belongs to it
    };
    /// Returns the last change at or before the output step that ends at `outputEnd`.
    const Change &changeAtOrBefore(std::int64_t outputEnd) const;
    /// Returns the values from `change` on.
    const Values &valuesAt(const Script &script, const Change &change) const;

    std::vector<Change> m_changes; ///< by frame; the first is the start of the run
    /// A cached interval.
    struct Composed
    {
        std::int64_t from = -1; ///< frame of the change that begins it; -1: empty entry
        std::shared_ptr<const ComposedInterval> interval;
    };
    /// The last two intervals, the latest first. Two suffice because an output step asks for the intervals
    /// before and after a change in turn.
    mutable std::array<Composed, 2> m_cache;
    mutable Values m_values;          ///< the last result of valuesAt()
    mutable std::size_t m_end = 0;    ///< index after the last event in `m_values`
    mutable bool m_hasValues = false; ///< whether `m_values` belongs to the current script
};

}
