#include "sim/track.h"

#include "sim/carry_over.h"
#include "sim/guilt.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace sim {

namespace {

/// The memory of a kept state, with the map's node, the pointer's counters and the allocator's headers.
std::size_t costOf(const State &state)
{
    constexpr std::size_t bookkeeping = 192;
    return memoryOf(state) + bookkeeping;
}

struct Failure
{
    StopReason reason;
    int point; ///< the point count for what belongs to no point
};

/// What keeps a run from going on from `state`, if anything does.
std::optional<Failure> failureOf(const State &state)
{
    if (state.ahead.stuck >= 0) // first: where steps lead no further, tries may have left any numbers
        return Failure{StopReason::tooManySteps, state.ahead.stuck};
    if (const int point = firstNotFinite(state); point >= 0)
        return Failure{StopReason::notFinite, point};
    return {};
}

/// -1 for what belongs to no point.
int pointOf(const Failure &failure, const State &state)
{
    return failure.point < state.points() ? failure.point : -1;
}

/// Returns false when `goesOn` (which may be empty) said no.
bool run(const Phase &phase, State &state, const GoesOn &goesOn)
{
    if (goesOn && phase.runWhile)
        return phase.runWhile(state, goesOn);
    phase.run(state);
    return !goesOn || goesOn();
}

/// What a method has computed ahead holds as long as nothing comes in from outside.
void forgetAhead(State &state)
{
    state.ahead.from = state.ahead.to = 0.0;
    state.resting.setZero();
}

}

Track::Track(Script script, std::size_t budget) : m_script(std::move(script)), m_budget(budget)
{
    m_changes = changesOf(m_script);
    check(m_script, 0);
    m_segment = segmentFor(0);
    m_now = m_segment->scene.start;
    keep();
}

std::vector<Track::Change> Track::changesOf(const Script &script)
{
    std::vector<Change> changes = {{0, script.values}};
    const std::int64_t rowFrames = script.step.rowFrames;
    for (const Event &event : script.input) {
        const Set *set = std::get_if<Set>(&event.what);
        if (!set)
            continue;
        const std::int64_t row = std::max<std::int64_t>(1, (event.frame + rowFrames - 1) / rowFrames);
        if (changes.back().frame != row * rowFrames)
            changes.push_back({row * rowFrames, changes.back().values});
        changes.back().values.set(set->parameter, set->value);
    }
    return changes;
}

void Track::check(const Script &script, std::int64_t frame)
{
    for (const Event &event : script.input)
        checkFinite(event);
    for (const Change &change : changesOf(script)) {
        if (change.frame >= frame)
            compose(sceneOf(script, change.values), *script.method, script.step);
    }
}

std::shared_ptr<const Segment> Track::segmentFor(std::int64_t rowEnd) const
{
    const auto past = std::upper_bound(m_changes.begin(), m_changes.end(), rowEnd,
                                       [](std::int64_t frame, const Change &c) { return frame < c.frame; });
    const Change &change = *std::prev(past);
    if (m_composed[0].from == change.frame)
        return m_composed[0].segment;
    std::swap(m_composed[0], m_composed[1]);
    if (m_composed[0].from != change.frame) {
        Segment segment{change.values, sceneOf(m_script, change.values), {}};
        segment.pipeline = compose(segment.scene, *m_script.method, m_script.step);
        m_composed[0] = {change.frame, std::make_shared<const Segment>(std::move(segment))};
    }
    return m_composed[0].segment;
}

void Track::seek(Cursor target)
{
    seek(target, {});
}

bool Track::seek(Cursor target, const GoesOn &goesOn)
{
    target.frame = std::max<std::int64_t>(0, target.frame) / rowFrames() * rowFrames();
    target.phase = std::max(0, target.phase);
    if (m_stop && target.frame > m_stop->frame)
        target = {m_stop->frame, 0};
    else if (m_stop && target.frame == m_stop->frame)
        target.phase = std::min(target.phase, m_stop->phases);
    const auto kept = std::prev(m_kept.upper_bound(target.frame));
    if (target < m_at || kept->first > m_at.frame)
        restore(kept->first);
    Next next = Next::goesOn;
    // Inside a row the numbers are looked at only where the cursor stops: where they are no good, the rest of the
    // row tells whether the run ends here.
    while (next == Next::goesOn && (m_at < target || (m_at.phase > 0 && failureOf(m_now))))
        next = runPhase(goesOn);
    if (next == Next::isLeftOff)
        restore(std::prev(m_kept.upper_bound(m_at.frame))->first);
    else if (next == Next::ends)
        return seek(target, goesOn); // now that the end is known
    return next != Next::isLeftOff;
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
    if (state.hold.point >= 0)
        forgetAhead(state);
    const std::int64_t rowStart = rowEnd - rowFrames();
    state.frame = rowEnd;
    state.outside.gust.reset();
    state.outside.newTargets.clear();
    const bool first = rowStart == 0;
    auto event = std::upper_bound(m_script.input.begin(), m_script.input.end(), first ? -1 : rowStart,
                                  [](std::int64_t frame, const Event &e) { return frame < e.frame; });
    for (; event != m_script.input.end() && event->frame <= rowEnd; ++event) {
        apply(state, segment->scene, *event);
        forgetAhead(state);
    }
    const int held = state.hold.point;
    if (held < 0)
        return;
    if (segment->scene.start.feels(held) && segment->scene.hasInertia(held))
        state.push(held, (1.0 / rowFrames()) * (state.hold.hand - state.at(held)));
    state.place(held, state.hold.hand);
}

void Track::apply(State &state, const Scene &scene, const Event &event) const
{
    if (const auto *pointer = std::get_if<Pointer>(&event.what)) {
        state.outside.pointer = pointer->at;
        state.outside.pointerDown = pointer->down;
    } else if (const auto *target = std::get_if<Target>(&event.what)) {
        state.outside.target = target->at;
        state.outside.newTargets.push_back(target->at);
    } else if (const auto *gust = std::get_if<Gust>(&event.what)) {
        state.outside.gust = gust->degrees;
    } else if (const auto *key = std::get_if<Key>(&event.what)) {
        state.outside.keys.*key->key = key->down;
    } else {
        applyHand(state, scene, event);
    }
}

void Track::applyHand(State &state, const Scene &scene, const Event &event) const
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

Track::Next Track::runPhase(const GoesOn &goesOn)
{
    if (m_at.phase == 0) {
        begin(m_now, m_at.frame + rowFrames());
        m_segment = segmentFor(m_at.frame + rowFrames());
    }
    const Pipeline &pipeline = m_segment->pipeline;
    if (!run(pipeline.phaseAt(m_at.phase), m_now, goesOn))
        return Next::isLeftOff;
    return ++m_at.phase < pipeline.phasesPerRow() ? Next::goesOn : endRow(goesOn);
}

Track::Next Track::endRow(const GoesOn &goesOn)
{
    if (failureOf(m_now))
        return stopHere(goesOn);
    m_at = {m_at.frame + rowFrames(), 0};
    m_computed = std::max(m_computed, m_at.frame);
    keep();
    return Next::goesOn;
}

Track::Next Track::stopHere(const GoesOn &goesOn)
{
    const std::int64_t last = m_at.frame;
    const std::optional<State> good = rowState(last, goesOn);
    if (!good)
        return Next::isLeftOff;
    const std::shared_ptr<const Segment> segment = segmentFor(last + rowFrames());
    Stop stop;
    stop.frame = last;
    State state = *good;
    begin(state, last + rowFrames());
    std::optional<Failure> failure = failureOf(state);
    while (!failure && stop.phases < segment->pipeline.phasesPerRow()) {
        const Phase &next = segment->pipeline.phaseAt(stop.phases);
        const State before = state;
        if (!run(next, state, goesOn))
            return Next::isLeftOff;
        failure = failureOf(state);
        stop.phase = next.title;
        if (failure) {
            const Guilt guilt = guiltOf(next, segment->scene, before, pointOf(*failure, state),
                                        m_script.method->directions());
            stop.effect = guilt.effect;
            stop.other = guilt.other;
        } else {
            ++stop.phases;
        }
    }
    if (failure) {
        stop.reason = failure->reason;
        stop.point = pointOf(*failure, state);
        if (stop.point >= 0)
            stop.body = segment->scene.names[static_cast<std::size_t>(stop.point)];
        if (stop.other >= 0)
            stop.otherBody = segment->scene.names[static_cast<std::size_t>(stop.other)];
    }
    m_stop = stop;
    m_now = *good;
    m_at = {last, 0};
    m_segment = segmentFor(last);
    return Next::ends;
}

std::optional<State> Track::rowState(std::int64_t frame, const GoesOn &goesOn) const
{
    if (m_at == Cursor{frame, 0})
        return m_now;
    const auto kept = std::prev(m_kept.upper_bound(frame));
    State state = *kept->second;
    for (std::int64_t end = kept->first + rowFrames(); end <= frame; end += rowFrames()) {
        begin(state, end);
        const std::shared_ptr<const Segment> segment = segmentFor(end);
        for (int phase = 0; phase < segment->pipeline.phasesPerRow(); ++phase) {
            if (!run(segment->pipeline.phaseAt(phase), state, goesOn))
                return {};
        }
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
        std::erase_if(m_kept, [this](const auto &kept) {
            const bool goes = kept.first / rowFrames() % m_spacing != 0;
            m_keptBytes -= goes ? costOf(*kept.second) : 0;
            return goes;
        });
    }
}

void Track::setBudget(std::size_t budget)
{
    m_budget = budget;
    thin();
}

State Track::begunAfter(State end, std::int64_t frame) const
{
    begin(end, frame + rowFrames());
    return end;
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
    State state = stateAt(rowStart);
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
        const bool pushed = before.speed(point) != state.speed(point); // a reaction, say
        if (phase.points.contains(point) || pushed)
            moment.live = phase.explain(before, state, point);
        all.push_back(std::move(moment));
    }
    return all;
}

void Track::replaceInput(std::vector<Event> input, std::int64_t frame)
{
    m_script.input = std::move(input);
    m_changes = changesOf(m_script);
    for (Composed &one : m_composed) {
        const bool stays = std::any_of(m_changes.begin(), m_changes.end(), [&](const Change &change) {
            return change.frame == one.from && change.values == one.segment->values;
        });
        if (!stays)
            one = {};
    }
    while (m_kept.rbegin()->first >= frame) { // from the end: a hand edits there, many times a second
        m_keptBytes -= costOf(*m_kept.rbegin()->second);
        m_kept.erase(std::prev(m_kept.end()));
    }
    m_computed = std::min(m_computed, m_at.frame);
    m_stop.reset();
    m_segment = segmentFor(m_at.frame);
}

}
