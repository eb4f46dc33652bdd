#include "sim/run/script/composed_intervals.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace sim {

namespace {

/// Whether a scene made from `a` has the bits of one made from `b`: 0 and -0 are equal, and may lead to other bits.
bool makeTheSame(const Values &a, const Values &b)
{
    return a == b && std::equal(a.all().begin(), a.all().end(), b.all().begin(),
                                [](const auto &one, const auto &other) {
                                    return std::signbit(one.second) == std::signbit(other.second);
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
    m_isBegun = false;
    for (Composed &one : m_composed) {
        const Change &change = changeBefore(std::max<std::int64_t>(0, one.from));
        const bool stays = one.interval && change.frame == one.from &&
                           makeTheSame(valuesAt(script, change), one.interval->values);
        if (!stays)
            one = {};
    }
}

void ComposedIntervals::check(const Script &script, std::int64_t frame) const
{
    std::set<std::vector<double>> checked;
    for (const Change &change : m_changes) {
        if (change.frame < frame)
            continue;
        std::vector<double> numbers; // nothing else changes on the way
        for (const auto &[id, number] : valuesAt(script, change).all())
            numbers.push_back(number);
        if (checked.insert(std::move(numbers)).second || change.frame == m_changes.back().frame)
            at(script, change.frame);
    }
}

const ComposedIntervals::Change &ComposedIntervals::changeBefore(std::int64_t outputEnd) const
{
    const auto past = std::upper_bound(m_changes.begin(), m_changes.end(), outputEnd,
                                       [](std::int64_t frame, const Change &c) { return frame < c.frame; });
    return *std::prev(past);
}

bool ComposedIntervals::areInSameInterval(std::int64_t one, std::int64_t other) const
{
    return changeBefore(one).frame == changeBefore(other).frame;
}

const Values &ComposedIntervals::valuesAt(const Script &script, const Change &change) const
{
    if (!m_isBegun || change.end < m_end) {
        m_values = script.values;
        m_end = 0;
        m_isBegun = true;
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
    const Change &change = changeBefore(outputEnd);
    if (m_composed[0].from == change.frame)
        return m_composed[0].interval;
    std::swap(m_composed[0], m_composed[1]);
    if (m_composed[0].from == change.frame)
        return m_composed[0].interval;
    const Values &values = valuesAt(script, change);
    for (const Composed &one : m_composed) {
        if (one.interval && makeTheSame(one.interval->values, values)) {
            m_composed[0] = {change.frame, one.interval};
            return m_composed[0].interval;
        }
    }
    ComposedInterval interval{values, sceneOf(script, values), {}};
    interval.pipeline = compose(interval.scene, *script.method, script.step);
    m_composed[0] = {change.frame, std::make_shared<const ComposedInterval>(std::move(interval))};
    return m_composed[0].interval;
}

}
