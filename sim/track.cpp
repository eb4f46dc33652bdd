#include "sim/track.h"

#include <algorithm>
#include <iterator>

namespace sim {

namespace {

/// Carries what `state` of scene `from` has over to scene `to`: bodies of the same name go on as they are, new
/// ones stand where `to` starts them, shifted by as much as the others have moved on the average.
State carryOver(const State &state, const Scene &from, const Scene &to)
{
    State next = to.start;
    Vec2 shift;
    int common = 0;
    for (int i = 0; i < next.points(); ++i) {
        const int old = from.find(to.names[static_cast<std::size_t>(i)]);
        if (old < 0)
            continue;
        shift = shift + (state.at(old) - to.start.at(i));
        ++common;
    }
    for (int i = 0; i < next.points(); ++i) {
        const int old = from.find(to.names[static_cast<std::size_t>(i)]);
        if (old >= 0) {
            next.place(i, state.at(old));
            next.push(i, state.speed(old));
            if (state.hold.point == old)
                next.hold = {i, state.hold.hand};
        } else if (common > 0) {
            next.place(i, next.at(i) + (1.0 / common) * shift);
        }
    }
    if (next.hold.point >= 0)
        next.inverseMass[next.hold.point] = 0.0;
    return next;
}

/// The memory of a kept state, with the map's node, the pointer's counters and the allocator's headers.
std::size_t costOf(const State &state)
{
    constexpr std::size_t bookkeeping = 192;
    return memoryOf(state) + bookkeeping;
}

}

Track::Track(Script script, std::size_t budget) : m_script(std::move(script)), m_budget(budget)
{
    collectChanges();
    m_segment = segmentFor(0);
    m_now = m_segment->scene.start;
    keep();
}

void Track::collectChanges()
{
    m_changes = {{0, m_script.values}};
    for (const Event &event : m_script.input) {
        const Set *set = std::get_if<Set>(&event.what);
        if (!set)
            continue;
        const std::int64_t row = std::max<std::int64_t>(1, (event.frame + rowFrames() - 1) / rowFrames());
        if (m_changes.back().frame != row * rowFrames())
            m_changes.push_back({row * rowFrames(), m_changes.back().values});
        m_changes.back().values.set(set->parameter, set->value);
    }
    m_cachedFrom = -1;
}

std::shared_ptr<const Segment> Track::segmentFor(std::int64_t rowEnd) const
{
    const auto past = std::upper_bound(m_changes.begin(), m_changes.end(), rowEnd,
                                       [](std::int64_t frame, const Change &c) { return frame < c.frame; });
    const Change &change = *std::prev(past);
    if (m_cachedFrom != change.frame) {
        Segment segment{change.values, sceneOf(m_script, change.values), {}};
        segment.pipeline = compose(segment.scene, *m_script.method, m_script.step);
        m_cached = std::make_shared<const Segment>(std::move(segment));
        m_cachedFrom = change.frame;
    }
    return m_cached;
}

void Track::seek(Cursor target)
{
    target.frame = std::max<std::int64_t>(0, target.frame) / rowFrames() * rowFrames();
    target.phase = std::max(0, target.phase);
    if (m_stop && target.frame >= m_stop->frame)
        target = {m_stop->frame, 0};
    const auto kept = std::prev(m_kept.upper_bound(target.frame));
    if (target < m_at || kept->first > m_at.frame)
        restore(kept->first);
    while (m_at < target && !(m_stop && m_at.frame >= m_stop->frame))
        runPhase();
}

void Track::restore(std::int64_t frame)
{
    m_now = *m_kept.at(frame);
    m_at = {frame, 0};
    m_segment = segmentFor(frame);
}

void Track::begin(State &state, std::int64_t rowEnd) const
{
    const std::shared_ptr<const Segment> before = segmentFor(rowEnd - rowFrames());
    const std::shared_ptr<const Segment> segment = segmentFor(rowEnd);
    if (before != segment)
        state = carryOver(state, before->scene, segment->scene);
    const std::int64_t rowStart = rowEnd - rowFrames();
    const bool first = rowStart == 0;
    auto event = std::upper_bound(m_script.input.begin(), m_script.input.end(), first ? -1 : rowStart,
                                  [](std::int64_t frame, const Event &e) { return frame < e.frame; });
    for (; event != m_script.input.end() && event->frame <= rowEnd; ++event)
        apply(state, segment->scene, *event);
    const int held = state.hold.point;
    if (held < 0)
        return;
    if (segment->scene.start.feels(held))
        state.push(held, (1.0 / rowFrames()) * (state.hold.hand - state.at(held)));
    state.place(held, state.hold.hand);
}

void Track::apply(State &state, const Scene &scene, const Event &event) const
{
    const auto letGo = [&] {
        const int held = state.hold.point;
        if (held < 0)
            return;
        state.place(held, state.hold.hand);
        state.inverseMass[held] = scene.start.inverseMass[held];
        state.hold = {};
    };
    if (const Grab *grab = std::get_if<Grab>(&event.what)) {
        letGo();
        const int point = scene.find(grab->body);
        if (point < 0)
            return;
        state.hold = {point, state.at(point)};
        state.inverseMass[point] = 0.0;
    } else if (const Move *move = std::get_if<Move>(&event.what)) {
        if (state.hold.point >= 0)
            state.hold.hand = move->to;
    } else if (std::holds_alternative<Release>(event.what)) {
        letGo();
    }
}

void Track::runPhase()
{
    if (m_at.phase == 0) {
        begin(m_now, m_at.frame + rowFrames());
        m_segment = segmentFor(m_at.frame + rowFrames());
    }
    const Pipeline &pipeline = m_segment->pipeline;
    pipeline.phaseAt(m_at.phase).run(m_now);
    if (++m_at.phase == pipeline.phasesPerRow())
        endRow();
}

void Track::endRow()
{
    if (firstNotFinite(m_now) >= 0) {
        stopHere();
        return;
    }
    m_at = {m_at.frame + rowFrames(), 0};
    m_computed = std::max(m_computed, m_at.frame);
    keep();
}

void Track::stopHere()
{
    const std::int64_t last = m_at.frame;
    m_now = rowState(last);
    m_at = {last, 0};
    m_segment = segmentFor(last);
    Stop stop{last, {}, {}};
    const std::shared_ptr<const Segment> segment = segmentFor(last + rowFrames());
    State state = m_now;
    begin(state, last + rowFrames());
    int guilty = firstNotFinite(state);
    for (int phase = 0; phase < segment->pipeline.phasesPerRow() && guilty < 0; ++phase) {
        const Phase &next = segment->pipeline.phaseAt(phase);
        next.run(state);
        stop.phase = next.title;
        guilty = firstNotFinite(state);
    }
    if (guilty >= 0)
        stop.body = segment->scene.names[static_cast<std::size_t>(guilty)];
    m_stop = stop;
}

State Track::rowState(std::int64_t frame) const
{
    const auto kept = std::prev(m_kept.upper_bound(frame));
    State state = *kept->second;
    for (std::int64_t end = kept->first + rowFrames(); end <= frame; end += rowFrames()) {
        begin(state, end);
        const std::shared_ptr<const Segment> segment = segmentFor(end);
        for (int phase = 0; phase < segment->pipeline.phasesPerRow(); ++phase)
            segment->pipeline.phaseAt(phase).run(state);
    }
    return state;
}

void Track::keep()
{
    const std::int64_t row = m_at.frame / rowFrames();
    if (row % m_spacing != 0 || (m_budget == 0 && row > 0))
        return;
    if (m_kept.try_emplace(m_at.frame, std::make_shared<const State>(m_now)).second)
        m_keptBytes += costOf(m_now);
    thin();
}

void Track::thin()
{
    while (m_kept.size() > 1 && m_keptBytes > m_budget) {
        m_spacing *= 2;
        forget([this](std::int64_t frame) { return frame / rowFrames() % m_spacing != 0; });
    }
}

void Track::setBudget(std::size_t budget)
{
    m_budget = budget;
    thin();
}

State Track::preview(std::shared_ptr<const Segment> &segment) const
{
    State state = m_now;
    segment = m_segment;
    if (m_at.phase == 0) {
        begin(state, m_at.frame + rowFrames());
        segment = next();
    }
    return state;
}

std::vector<Moment> Track::moments(const std::string &body) const
{
    const bool between = m_at.phase == 0;
    if (between && m_at.frame == 0)
        return {};
    const std::int64_t rowStart = between ? m_at.frame - rowFrames() : m_at.frame;
    State state = rowState(rowStart);
    begin(state, rowStart + rowFrames());
    const std::shared_ptr<const Segment> segment = segmentFor(rowStart + rowFrames());
    const Pipeline &pipeline = segment->pipeline;
    const int point = segment->scene.find(body);
    if (point < 0)
        return {};
    const int done = between ? pipeline.phasesPerRow() : m_at.phase;
    const int stepStart = (done - 1) / pipeline.phasesPerStep() * pipeline.phasesPerStep();
    for (int i = 0; i < stepStart; ++i)
        pipeline.phaseAt(i).run(state);
    std::vector<Moment> all;
    for (int i = stepStart; i < done; ++i) {
        const Phase &phase = pipeline.phaseAt(i);
        const State before = state;
        phase.run(state);
        Moment moment{i - stepStart, {}};
        if (phase.points.contains(point))
            moment.live = phase.explain(before, state, point);
        all.push_back(std::move(moment));
    }
    return all;
}

void Track::replaceInput(std::vector<Event> input, std::int64_t frame)
{
    m_script.input = std::move(input);
    collectChanges();
    forget([frame](std::int64_t kept) { return kept >= frame; });
    m_computed = std::min(m_computed, m_at.frame);
    m_stop.reset();
    m_segment = segmentFor(m_at.frame);
}

template <class Which>
void Track::forget(Which &&which)
{
    std::erase_if(m_kept, [&](const auto &kept) {
        if (kept.first == 0 || !which(kept.first))
            return false;
        m_keptBytes -= costOf(*kept.second);
        return true;
    });
}

}
