#pragma once

#include "sim/run/script/script.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace sim {

/// The segments of a run, each composed when it is asked for: once for all those in which the values are the same, as long
/// as they are among the last ones.
class ComposedIntervals
{
public:
    ComposedIntervals() = default;
    explicit ComposedIntervals(const Script &script);

    /// Those of `script`, which differs from the one before in its input alone. What stays as it was is not composed
    /// again.
    void replace(const Script &script);
    /// Composes each scene that the script comes to from `frame` on. The last ones are at hand from then on.
    /// @throws Error when one does not fit its method
    void check(const Script &script, std::int64_t frame) const;
    /// The segment of the row that ends at `rowEnd`. `script` is the one that these are of.
    std::shared_ptr<const ComposedInterval> at(const Script &script, std::int64_t outputEnd) const;
    /// Whether no parameter is set between the rows that end at `one` and at `other`.
    bool areInSameInterval(std::int64_t one, std::int64_t other) const;

private:
    /// Parameters change with the row that ends at `frame`: all events before `end` of the script's input have happened.
    struct Change
    {
        std::int64_t frame = 0;
        std::size_t end = 0;
    };
    const Change &changeBefore(std::int64_t outputEnd) const;
    /// The values from `change` on.
    const Values &valuesAt(const Script &script, const Change &change) const;

    std::vector<Change> m_changes; ///< by frame; the first is the start
    struct Composed
    {
        std::int64_t from = -1; ///< frame of its change
        std::shared_ptr<const ComposedInterval> interval;
    };
    /// The segments last asked for, the latest first: those before and after a change are asked for in turn.
    mutable std::array<Composed, 2> m_composed;
    mutable Values m_values;        ///< that valuesAt() found last
    mutable std::size_t m_end = 0;  ///< and the event before which they hold
    mutable bool m_isBegun = false; ///< whether they are of this script
};

}
