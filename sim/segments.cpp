#include "sim/segments.h"

#include <algorithm>
#include <iterator>

namespace sim {

Segments::Segments(const Script &script) : m_changes{{0, script.values}}
{
    const std::int64_t rowFrames = script.step.rowFrames;
    for (const Event &event : script.input) {
        const Set *set = std::get_if<Set>(&event.what);
        if (!set)
            continue;
        const std::int64_t row = std::max<std::int64_t>(1, (event.frame + rowFrames - 1) / rowFrames);
        if (m_changes.back().frame != row * rowFrames)
            m_changes.push_back({row * rowFrames, m_changes.back().values});
        m_changes.back().values.set(set->parameter, set->value);
    }
}

void Segments::replace(const Script &script)
{
    m_changes = Segments(script).m_changes;
    for (Composed &one : m_composed) {
        const bool stays = std::any_of(m_changes.begin(), m_changes.end(), [&](const Change &change) {
            return change.frame == one.from && change.values == one.segment->values;
        });
        if (!stays)
            one = {};
    }
}

void Segments::check(const Script &script, std::int64_t frame) const
{
    for (const Change &change : m_changes) {
        if (change.frame >= frame)
            at(script, change.frame);
    }
}

std::shared_ptr<const Segment> Segments::at(const Script &script, std::int64_t rowEnd) const
{
    const auto past = std::upper_bound(m_changes.begin(), m_changes.end(), rowEnd,
                                       [](std::int64_t frame, const Change &c) { return frame < c.frame; });
    const Change &change = *std::prev(past);
    if (m_composed[0].from == change.frame)
        return m_composed[0].segment;
    std::swap(m_composed[0], m_composed[1]);
    if (m_composed[0].from != change.frame) {
        Segment segment{change.values, sceneOf(script, change.values), {}};
        segment.pipeline = compose(segment.scene, *script.method, script.step);
        m_composed[0] = {change.frame, std::make_shared<const Segment>(std::move(segment))};
    }
    return m_composed[0].segment;
}

}
