#include "sim/run/track.h"

#include "sim/pipeline/run_step.h"
#include "sim/run/failure_cause.h"
#include "sim/run/finite.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/output_step.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <limits>

namespace sim {

namespace {

struct Failure
{
    StopReason reason;
    int point; ///< the point count for what belongs to no point
};

/// What keeps a run from going on from `state`, if anything does.
std::optional<Failure> failureOf(const State &state)
{
    // first: where steps lead no further, tries may have left any numbers
    if (const int point = firstStuck(state); point >= 0)
        return Failure{StopReason::tooManySteps, point};
    if (const int point = firstNotFinite(state); point >= 0)
        return Failure{StopReason::notFinite, point};
    return {};
}

void checkInput(const Script &script)
{
    for (const Event &event : script.input)
        checkFinite(event);
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

}

Track::Track(Script script, std::size_t budget, Sleeping sleeping)
    : m_script(std::move(script)), m_segments(m_script), m_sleeping(sleeping),
      m_history(budget, m_script.step.rowFrames)
{
    checkInput(m_script);
    m_segments.check(m_script, 0);
    m_segment = segmentAt(0);
    m_now = m_segment->scene.start;
    m_history.keep(m_now);
}

void Track::check(const Script &script)
{
    checkInput(script);
    Segments(script).check(script, 0);
}

Track::NewInput Track::prepared(std::vector<Event> events, std::int64_t frame) const
{
    Script changed = m_script;
    changed.input = std::move(events);
    checkInput(changed);
    Segments segments = m_segments;
    segments.replace(changed);
    segments.check(changed, frame);
    return {std::move(changed.input), frame, std::move(segments)};
}

int Track::phasesPerRow() const
{
    return next()->pipeline.phasesPerRow();
}

void Track::seek(Cursor target)
{
    seek(target, {});
}

bool Track::seek(Cursor target, const GoesOn &goesOn)
{
    const FlushTiny flush;
    target.frame = std::max<std::int64_t>(0, target.frame) / rowFrames() * rowFrames();
    target.phase = std::max(0, target.phase);
    if (m_stop && target.frame > m_stop->frame)
        target = {m_stop->frame, 0};
    else if (m_stop && target.frame == m_stop->frame)
        target.phase = std::min(target.phase, m_stop->phases);
    if (target < m_at)
        restore(target.frame);
    else if (m_at.phase == 0)
        sleepOn(target.frame);
    if (knownBefore(target.frame) > m_at.frame)
        restore(target.frame);
    Next next = Next::goesOn;
    // Inside a row the numbers are looked at only where the cursor stops: where they are no good, the rest of the
    // row tells whether the run ends here.
    while (next == Next::goesOn && (m_at < target || (m_at.phase > 0 && failureOf(m_now)))) {
        if (m_at.phase > 0 || !sleepOn(target.frame))
            next = runOn(target, goesOn);
    }
    if (next == Next::isLeftOff)
        restore(m_at.frame);
    else if (next == Next::ends)
        return seek(target, goesOn); // now that the end is known
    return next != Next::isLeftOff;
}

void Track::restore(std::int64_t frame)
{
    m_now = known(frame);
    m_at = {m_now.frame, 0};
    m_segment = segmentAt(m_now.frame);
    m_computed = std::max(m_computed, m_at.frame);
    m_blocks.wakeAll();
}

void Track::begin(State &state, std::int64_t rowEnd) const
{
    sim::beginRow(state, m_script, segmentAt(rowEnd - rowFrames()), segmentAt(rowEnd), rowEnd);
}

void Track::beginRow(Cursor target)
{
    const std::int64_t rowEnd = m_at.frame + rowFrames();
    const int held = m_now.hold.point;
    begin(m_now, rowEnd);
    const std::shared_ptr<const Segment> segment = segmentAt(rowEnd);
    if (segment != m_segment || setsParameters(m_script, rowEnd))
        m_blocks.wakeAll();
    m_segment = segment;
    if (!m_blocks.asleep().empty()) {
        m_blocks.wake(segment->pipeline, held);
        for (const int point : grabbedIn(m_script, segment->scene, rowEnd))
            m_blocks.wake(segment->pipeline, point);
    }
    m_skips = Cursor{rowEnd, 0} <= target; // inside a row even what rests may be elsewhere
}

Track::Next Track::runOn(Cursor target, const GoesOn &goesOn)
{
    if (m_at.phase == 0)
        beginRow(target);
    const Pipeline &pipeline = m_segment->pipeline;
    const int step = pipeline.phasesPerStep();
    const bool whole = m_at.phase % step == 0 && Cursor{m_at.frame, m_at.phase + step} <= target;
    const std::vector<char> none;
    const bool isDone = whole ? runWhole(pipeline, m_now, m_skips ? m_blocks.asleep() : none, goesOn)
                              : run(pipeline.phaseAt(m_at.phase), m_now, goesOn);
    if (!isDone)
        return Next::isLeftOff;
    m_at.phase += whole ? step : 1;
    return m_at.phase < pipeline.phasesPerRow() ? Next::goesOn : endRow(goesOn);
}

bool Track::runWhole(const Pipeline &pipeline, State &state, const std::vector<char> &asleep,
                     const GoesOn &goesOn) const
{
    const bool mayTakeLong = std::any_of(pipeline.phases.begin(), pipeline.phases.end(),
                                         [](const Phase &phase) { return phase.runWhile != nullptr; });
    if (!mayTakeLong || !goesOn) {
        runStep(pipeline, state, m_crew, asleep);
        return !goesOn || goesOn();
    }
    return std::all_of(pipeline.phases.begin(), pipeline.phases.end(),
                       [&](const Phase &phase) { return run(phase, state, goesOn); });
}

Track::Next Track::endRow(const GoesOn &goesOn)
{
    const bool isGood = firstStuck(m_now) < 0 && isFinite(m_now, m_crew);
    if (!isGood)
        return stopHere(goesOn);
    m_at = {m_at.frame + rowFrames(), 0};
    m_computed = std::max(m_computed, m_at.frame);
    if (!sleep()) {
        m_history.keep(m_now);
        fallAsleep();
    }
    return Next::goesOn;
}

Track::Next Track::stopHere(const GoesOn &goesOn)
{
    const std::int64_t last = m_at.frame;
    const std::optional<State> good = rowState(last, goesOn);
    if (!good)
        return Next::isLeftOff;
    const std::shared_ptr<const Segment> segment = segmentAt(last + rowFrames());
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
    m_segment = segmentAt(last);
    return Next::ends;
}

bool Track::runRow(State &state, std::int64_t rowEnd, const GoesOn &goesOn) const
{
    begin(state, rowEnd);
    const std::shared_ptr<const Segment> segment = segmentAt(rowEnd);
    for (int step = 0; step < segment->pipeline.step.perRow; ++step) {
        if (!runWhole(segment->pipeline, state, {}, goesOn))
            return false;
    }
    return true;
}

std::optional<State> Track::rowState(std::int64_t frame, const GoesOn &goesOn) const
{
    if (m_at == Cursor{frame, 0})
        return m_now;
    const FlushTiny flush;
    State state = known(frame);
    while (state.frame + rowFrames() <= frame) {
        if (!runRow(state, state.frame + rowFrames(), goesOn))
            return {};
    }
    return state;
}

void Track::setBudget(std::size_t budget)
{
    m_history.setBudget(budget);
}

State Track::begunAfter(State end, std::int64_t frame) const
{
    const FlushTiny flush;
    begin(end, frame + rowFrames());
    return end;
}

State Track::preview(std::shared_ptr<const Segment> &segment) const
{
    const FlushTiny flush;
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
    const FlushTiny flush;
    const bool between = m_at.phase == 0;
    if (between && m_at.frame == 0)
        return {};
    const std::int64_t rowStart = between ? m_at.frame - rowFrames() : m_at.frame;
    State state = stateAt(rowStart);
    begin(state, rowStart + rowFrames());
    const std::shared_ptr<const Segment> segment = segmentAt(rowStart + rowFrames());
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

void Track::replaceInput(NewInput input)
{
    m_script.input = std::move(input.events);
    m_segments = std::move(input.segments);
    // events of frame 0 come with the first row: the start stays
    const std::int64_t frame = std::max<std::int64_t>(1, input.frame);
    m_history.forget(frame);
    m_watch.forget(frame);
    m_computed = std::min(m_computed, m_at.frame);
    m_stop.reset();
    m_segment = segmentAt(m_at.frame);
}

namespace {

/// Bytes that the states of one round may take, if they are several.
constexpr std::size_t mostOfARound = std::size_t{16} << 20;

}

std::int64_t Track::knownBefore(std::int64_t frame) const
{
    const std::int64_t kept = m_history.before(frame);
    const Sleep *sleep = m_history.sleepBefore(frame);
    const std::int64_t row = frame / rowFrames() * rowFrames();
    return sleep ? std::max(kept, std::min(row, lastOf(*sleep))) : kept;
}

State Track::known(std::int64_t frame) const
{
    const std::int64_t nearest = knownBefore(frame);
    const Sleep *sleep = sleepAt(nearest);
    return sleep ? sleep->at(nearest) : m_history.at(nearest);
}

const Sleep *Track::sleepAt(std::int64_t frame) const
{
    const Sleep *sleep = m_history.sleepBefore(frame);
    return sleep && frame <= lastOf(*sleep) ? sleep : nullptr;
}

std::int64_t Track::lastOf(const Sleep &sleep) const
{
    const std::optional<std::int64_t> wakes = nextInput(m_script, sleep.from());
    return wakes ? *wakes - rowFrames() : std::numeric_limits<std::int64_t>::max();
}

bool Track::isOver() const
{
    if (m_stop && m_at.frame == m_stop->frame)
        return true;
    const Sleep *sleep = this->sleep();
    return m_at.phase == 0 && sleep && sleep->isStill() && !nextInput(m_script, sleep->from());
}

void Track::fallAsleep()
{
    if (m_sleeping == Sleeping::never)
        return;
    blocksFallAsleep();
    const std::optional<SleepWatch::Again> again = m_watch.look(m_now, rowFrames());
    const std::int64_t rows = again ? (m_at.frame - again->since) / rowFrames() : 0;
    const bool fits = rows == 1 || static_cast<std::size_t>(rows) * memoryOf(m_now) <= mostOfARound;
    if (!again || !fits || nextInput(m_script, again->since).value_or(m_at.frame + 1) <= m_at.frame ||
        keepsAwake(m_segment->pipeline, m_now))
        return;
    // The round that has just ended is the one that comes, too, unless something comes in: so input to come, which may
    // be another one by then, is not in it.
    std::vector<std::shared_ptr<const State>> round;
    State state = *m_watch.mark();
    while (static_cast<std::int64_t>(round.size()) < rows) {
        auto later = std::make_shared<State>(state);
        later->frame += rows * rowFrames();
        later->evaluations += again->evaluations;
        round.push_back(std::move(later));
        if (static_cast<std::int64_t>(round.size()) < rows)
            runRow(state, state.frame + rowFrames(), {});
    }
    m_history.add(Sleep(std::move(round), rowFrames(), again->evaluations));
}

void Track::blocksFallAsleep()
{
    const State *mark = m_watch.mark();
    if (!m_segment->pipeline.blocks.empty() && mark && mark->frame + rowFrames() == m_at.frame &&
        m_segments.isSameStretch(mark->frame, m_at.frame))
        m_blocks.look(m_segment->pipeline, *mark, m_now);
}

bool Track::sleepOn(std::int64_t frame)
{
    const Sleep *sleep = sleepAt(m_at.frame);
    const std::int64_t to = sleep ? std::min(frame, lastOf(*sleep)) : m_at.frame;
    if (to <= m_at.frame)
        return false;
    sleep->take(m_now, to);
    m_at = {to, 0};
    m_segment = segmentAt(to);
    m_computed = std::max(m_computed, to);
    return true;
}

}
