#include "sim/run/script/composed_intervals.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace sim {

namespace {

/// Returns whether scenes built from `a` and `b` have the same bits. 0 and -0 are equal but can give
/// different bits.
bool haveSameBits(const Values &a, const Values &b)
{
    return a == b &&
           std::equal(a.all().begin(), a.all().end(), b.all().begin(), [](const auto &x, const auto &y) {
               return std::signbit(x.second) == std::signbit(y.second);
           });
}

}

ComposedIntervals::ComposedIntervals(const Script &script) : m_changes{{0, 0}}
{
    for (std::size_t i = 0; i < script.input.size(); ++i) {
        const Event &event = script.input[i];
        if (!std::holds_alternative<Set>(event.what))
            continue;
        const std::int64_t outputEnd = outputStepEnd(event.frame, script.step.framesPerOutput);
        if (m_changes.back().frame != outputEnd)
            m_changes.push_back({outputEnd, 0});
        m_changes.back().end = i + 1;
    }
}

void ComposedIntervals::replace(const Script &script)
{
    m_changes = ComposedIntervals(script).m_changes;
    m_hasValues = false;
    for (Composed &entry : m_cache) {
        const Change &change = changeAtOrBefore(std::max<std::int64_t>(0, entry.from));
        const bool isUnchanged = entry.interval && change.frame == entry.from &&
                                 haveSameBits(valuesAt(script, change), entry.interval->values);
        if (!isUnchanged)
            entry = {};
    }
}

void ComposedIntervals::check(const Script &script, std::int64_t frame) const
{
    std::set<std::vector<double>> checkedValues;
    for (const Change &change : m_changes) {
        if (change.frame < frame)
            continue;
        std::vector<double> numbers; // the set of parameters is the same for all changes
        for (const auto &[id, number] : valuesAt(script, change).all())
            numbers.push_back(number);
        if (checkedValues.insert(std::move(numbers)).second || change.frame == m_changes.back().frame)
            at(script, change.frame);
    }
}

const ComposedIntervals::Change &ComposedIntervals::changeAtOrBefore(std::int64_t outputEnd) const
{
    const auto next = std::upper_bound(m_changes.begin(), m_changes.end(), outputEnd,
                                       [](std::int64_t frame, const Change &c) { return frame < c.frame; });
    return *std::prev(next);
}

bool ComposedIntervals::areInSameInterval(std::int64_t firstEnd, std::int64_t secondEnd) const
{
    return changeAtOrBefore(firstEnd).frame == changeAtOrBefore(secondEnd).frame;
}

const Values &ComposedIntervals::valuesAt(const Script &script, const Change &change) const
{
    if (!m_hasValues || change.end < m_end) {
        m_values = script.values;
        m_end = 0;
        m_hasValues = true;
    }
    for (; m_end < change.end; ++m_end) {
        if (const Set *set = std::get_if<Set>(&script.input[m_end].what))
            m_values.set(set->parameter, set->value);
    }
    return m_values;
}

std::shared_ptr<const ComposedInterval> ComposedIntervals::at(const Script &script,
                                                              std::int64_t outputEnd) const
{
    const Change &change = changeAtOrBefore(outputEnd);
    if (m_cache[0].from == change.frame)
        return m_cache[0].interval;
    std::swap(m_cache[0], m_cache[1]);
    if (m_cache[0].from == change.frame)
        return m_cache[0].interval;
    const Values &values = valuesAt(script, change);
    for (const Composed &entry : m_cache) {
        if (entry.interval && haveSameBits(entry.interval->values, values)) {
            m_cache[0] = {change.frame, entry.interval};
            return m_cache[0].interval;
        }
    }
    ComposedInterval interval{values, sceneOf(script, values), {}};
    interval.pipeline = compose(interval.scene, *script.method, script.step);
    m_cache[0] = {change.frame, std::make_shared<const ComposedInterval>(std::move(interval))};
    return m_cache[0].interval;
}

}
