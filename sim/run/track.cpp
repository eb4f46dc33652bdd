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
    int point; ///< the number of points if the failed number belongs to no point
};

/// Returns the failure in `state`, if any.
std::optional<Failure> failureOf(const State &state)
{
    if (state.stepFailed)
        return Failure{StopReason::stepFailed, state.pointCount()};
    // Before the numbers, because rejected attempts of a stuck method may have left numbers that are not finite.
    if (const int point = firstStuckPoint(state); point >= 0)
        return Failure{StopReason::tooManySteps, point};
    if (const int point = firstNonFinitePoint(state); point >= 0)
        return Failure{StopReason::notFinite, point};
    return {};
}

void checkInput(const Script &script)
{
    for (const Event &event : script.input)
        checkFinite(event);
}

/// Returns the failed point, or -1 if the failed number belongs to no point.
int pointOf(const Failure &failure, const State &state)
{
    return failure.point < state.pointCount() ? failure.point : -1;
}

/// Runs `phase`. Returns false if `shouldContinue` (which may be empty) was false.
bool run(const Phase &phase, State &state, const ShouldContinue &shouldContinue)
{
    if (shouldContinue && phase.runInterruptible)
        return phase.runInterruptible(state, shouldContinue);
    phase.run(state);
    return !shouldContinue || shouldContinue();
}

}

Track::Track(Script script, std::size_t budget, Sleeping sleeping)
    : m_script(std::move(script)), m_intervals(m_script), m_sleeping(sleeping),
      m_keyframes(budget, m_script.step.framesPerOutput)
{
    checkInput(m_script);
    m_intervals.check(m_script, 0);
    m_interval = intervalAt(0);
    m_now = m_interval->scene.start;
    m_keyframes.store(m_now);
}

void Track::check(const Script &script)
{
    checkInput(script);
    ComposedIntervals(script).check(script, 0);
}

Track::NewInput Track::prepareInput(std::vector<Event> events, std::int64_t frame) const
{
    Script changed = m_script;
    changed.input = std::move(events);
    checkInput(changed);
    ComposedIntervals intervals = m_intervals;
    intervals.replace(changed);
    intervals.check(changed, frame);
    return {std::move(changed.input), frame, std::move(intervals)};
}

int Track::phasesPerOutput() const
{
    return nextInterval()->pipeline.phasesPerOutput();
}

void Track::seek(Cursor target)
{
    seek(target, {});
}

bool Track::seek(Cursor target, const ShouldContinue &shouldContinue)
{
    const FlushDenormals flush;
    target.frame = std::max<std::int64_t>(0, target.frame) / framesPerOutput() * framesPerOutput();
    target.phase = std::max(0, target.phase);
    if (m_stop && target.frame > m_stop->frame)
        target = {m_stop->frame, 0};
    else if (m_stop && target.frame == m_stop->frame)
        target.phase = std::min(target.phase, m_stop->phases);
    if (target < m_at)
        restore(target.frame);
    else if (m_at.phase == 0)
        skipSleep(target.frame);
    if (cachedFrameBefore(target.frame) > m_at.frame)
        restore(target.frame);
    Progress next = Progress::continues;
    // Within an output step, only the state at the target is checked. If it is not finite, the loop computes
    // the rest of the output step, whose end decides whether the run ends here.
    while (next == Progress::continues && (m_at < target || (m_at.phase > 0 && failureOf(m_now)))) {
        if (m_at.phase > 0 || !skipSleep(target.frame))
            next = advance(target, shouldContinue);
    }
    if (next == Progress::cancelled)
        restore(m_at.frame);
    else if (next == Progress::stopped)
        return seek(target, shouldContinue); // with the end known
    return next != Progress::cancelled;
}

void Track::restore(std::int64_t frame)
{
    m_now = cachedState(frame);
    m_at = {m_now.frame, 0};
    m_interval = intervalAt(m_now.frame);
    m_computed = std::max(m_computed, m_at.frame);
    m_blockDetector.wakeAll();
}

void Track::applyInput(State &state, std::int64_t outputEnd) const
{
    sim::beginOutputStep(state, m_script, intervalAt(outputEnd - framesPerOutput()), intervalAt(outputEnd),
                         outputEnd);
}

void Track::beginOutputStep(Cursor target)
{
    const std::int64_t outputEnd = m_at.frame + framesPerOutput();
    const int draggedPoint = m_now.hold.point;
    applyInput(m_now, outputEnd);
    const std::shared_ptr<const ComposedInterval> interval = intervalAt(outputEnd);
    if (interval != m_interval || setsParameters(m_script, outputEnd))
        m_blockDetector.wakeAll();
    m_interval = interval;
    if (!m_blockDetector.asleep().empty()) {
        m_blockDetector.wake(interval->pipeline, draggedPoint);
        for (const int point : grabbedPoints(m_script, interval->scene, outputEnd))
            m_blockDetector.wake(interval->pipeline, point);
    }
    m_skipsSleepingBlocks = Cursor{outputEnd, 0} <= target; // a sleeping block may move within an output step
}

Track::Progress Track::advance(Cursor target, const ShouldContinue &shouldContinue)
{
    if (m_at.phase == 0)
        beginOutputStep(target);
    const Pipeline &pipeline = m_interval->pipeline;
    const int step = pipeline.phasesPerStep();
    const bool isWholeStep = m_at.phase % step == 0 && Cursor{m_at.frame, m_at.phase + step} <= target;
    const std::vector<char> none;
    const bool isDone =
        isWholeStep ? runOneStep(pipeline, m_now, m_skipsSleepingBlocks ? m_blockDetector.asleep() : none,
                                 shouldContinue)
                    : run(pipeline.phaseAt(m_at.phase), m_now, shouldContinue);
    if (!isDone)
        return Progress::cancelled;
    m_at.phase += isWholeStep ? step : 1;
    return m_at.phase < pipeline.phasesPerOutput() ? Progress::continues : endOutputStep(shouldContinue);
}

bool Track::runOneStep(const Pipeline &pipeline, State &state, const std::vector<char> &asleep,
                       const ShouldContinue &shouldContinue) const
{
    const bool mayTakeLong =
        std::any_of(pipeline.phases.begin(), pipeline.phases.end(),
                    [](const Phase &phase) { return phase.runInterruptible != nullptr; });
    if (!mayTakeLong || !shouldContinue) {
        runStep(pipeline, state, m_pool, asleep);
        return !shouldContinue || shouldContinue();
    }
    return std::all_of(pipeline.phases.begin(), pipeline.phases.end(),
                       [&](const Phase &phase) { return run(phase, state, shouldContinue); });
}

Track::Progress Track::endOutputStep(const ShouldContinue &shouldContinue)
{
    const bool isGood = !m_now.stepFailed && firstStuckPoint(m_now) < 0 && isFinite(m_now, m_pool);
    if (!isGood)
        return recordStop(shouldContinue);
    m_at = {m_at.frame + framesPerOutput(), 0};
    m_computed = std::max(m_computed, m_at.frame);
    if (!sleep()) {
        m_keyframes.store(m_now);
        detectSleep();
    }
    return Progress::continues;
}

Track::Progress Track::recordStop(const ShouldContinue &shouldContinue)
{
    const std::int64_t last = m_at.frame;
    const std::optional<State> good = outputState(last, shouldContinue);
    if (!good)
        return Progress::cancelled;
    const std::shared_ptr<const ComposedInterval> interval = intervalAt(last + framesPerOutput());
    Stop stop;
    stop.frame = last;
    State state = *good;
    applyInput(state, last + framesPerOutput());
    std::optional<Failure> failure = failureOf(state);
    while (!failure && stop.phases < interval->pipeline.phasesPerOutput()) {
        const Phase &next = interval->pipeline.phaseAt(stop.phases);
        const State before = state;
        if (!run(next, state, shouldContinue))
            return Progress::cancelled;
        failure = failureOf(state);
        stop.phase = next.title;
        if (failure) {
            const FailureCause cause = failureCauseOf(next, interval->scene, before, pointOf(*failure, state),
                                                      m_script.method->directionRule());
            stop.effect = cause.effect;
            stop.other = cause.other;
        } else {
            ++stop.phases;
        }
    }
    if (failure) {
        stop.reason = failure->reason;
        stop.point = pointOf(*failure, state);
        if (stop.point >= 0)
            stop.body = interval->scene.names[static_cast<std::size_t>(stop.point)];
        if (stop.other >= 0)
            stop.otherBody = interval->scene.names[static_cast<std::size_t>(stop.other)];
    }
    m_stop = stop;
    m_now = *good;
    m_at = {last, 0};
    m_interval = intervalAt(last);
    return Progress::stopped;
}

bool Track::runOutputStep(State &state, std::int64_t outputEnd, const ShouldContinue &shouldContinue) const
{
    applyInput(state, outputEnd);
    const std::shared_ptr<const ComposedInterval> interval = intervalAt(outputEnd);
    for (int step = 0; step < interval->pipeline.step.stepsPerOutput; ++step) {
        if (!runOneStep(interval->pipeline, state, {}, shouldContinue))
            return false;
    }
    return true;
}

std::optional<State> Track::outputState(std::int64_t frame, const ShouldContinue &shouldContinue) const
{
    if (m_at == Cursor{frame, 0})
        return m_now;
    const FlushDenormals flush;
    State state = cachedState(frame);
    while (state.frame + framesPerOutput() <= frame) {
        if (!runOutputStep(state, state.frame + framesPerOutput(), shouldContinue))
            return {};
    }
    return state;
}

void Track::setBudget(std::size_t budget)
{
    m_keyframes.setBudget(budget);
}

State Track::stateAfterInput(State end, std::int64_t frame) const
{
    const FlushDenormals flush;
    applyInput(end, frame + framesPerOutput());
    return end;
}

State Track::preview(std::shared_ptr<const ComposedInterval> &interval) const
{
    const FlushDenormals flush;
    State state = m_now;
    interval = m_interval;
    if (m_at.phase == 0) {
        applyInput(state, m_at.frame + framesPerOutput());
        interval = nextInterval();
    }
    return state;
}

std::vector<PhaseExplanation> Track::explainPhases(const std::string &body) const
{
    const FlushDenormals flush;
    const bool between = m_at.phase == 0;
    if (between && m_at.frame == 0)
        return {};
    const std::int64_t outputStart = between ? m_at.frame - framesPerOutput() : m_at.frame;
    State state = stateAt(outputStart);
    applyInput(state, outputStart + framesPerOutput());
    const std::shared_ptr<const ComposedInterval> interval = intervalAt(outputStart + framesPerOutput());
    const Pipeline &pipeline = interval->pipeline;
    const int point = interval->scene.find(body);
    if (point < 0)
        return {};
    const int done = between ? pipeline.phasesPerOutput() : m_at.phase;
    const int stepStart = (done - 1) / pipeline.phasesPerStep() * pipeline.phasesPerStep();
    for (int i = 0; i < stepStart; ++i)
        pipeline.phaseAt(i).run(state);
    std::vector<PhaseExplanation> all;
    for (int i = stepStart; i < done; ++i) {
        const Phase &phase = pipeline.phaseAt(i);
        const State before = state;
        phase.run(state);
        PhaseExplanation moment{i - stepStart, {}};
        const bool pushed = before.velocityOf(point) != state.velocityOf(point); // a reaction, for example
        if (phase.points.contains(point) || pushed)
            moment.live = phase.explain(before, state, point);
        all.push_back(std::move(moment));
    }
    return all;
}

void Track::replaceInput(NewInput input)
{
    m_script.input = std::move(input.events);
    m_intervals = std::move(input.intervals);
    // The events of frame 0 belong to the first output step, so the initial state stays.
    const std::int64_t frame = std::max<std::int64_t>(1, input.frame);
    m_keyframes.forget(frame);
    m_cycleDetector.forget(frame);
    m_computed = std::min(m_computed, m_at.frame);
    m_stop.reset();
    m_interval = intervalAt(m_at.frame);
}

namespace {

/// Bytes that the states of a cycle may take, if it has more than one.
constexpr std::size_t maxCycleBytes = std::size_t{16} << 20;

}

std::int64_t Track::cachedFrameBefore(std::int64_t frame) const
{
    const std::int64_t kept = m_keyframes.lastAtOrBefore(frame);
    const Sleep *sleep = m_keyframes.lastSleepAtOrBefore(frame);
    const std::int64_t outputEnd = frame / framesPerOutput() * framesPerOutput();
    return sleep ? std::max(kept, std::min(outputEnd, lastFrameOf(*sleep))) : kept;
}

State Track::cachedState(std::int64_t frame) const
{
    const std::int64_t nearest = cachedFrameBefore(frame);
    const Sleep *sleep = sleepAt(nearest);
    return sleep ? sleep->at(nearest) : m_keyframes.at(nearest);
}

const Sleep *Track::sleepAt(std::int64_t frame) const
{
    const Sleep *sleep = m_keyframes.lastSleepAtOrBefore(frame);
    return sleep && frame <= lastFrameOf(*sleep) ? sleep : nullptr;
}

std::int64_t Track::lastFrameOf(const Sleep &sleep) const
{
    const std::optional<std::int64_t> nextInput = nextInputFrame(m_script, sleep.from());
    return nextInput ? *nextInput - framesPerOutput() : std::numeric_limits<std::int64_t>::max();
}

bool Track::isFinished() const
{
    if (m_stop && m_at.frame == m_stop->frame)
        return true;
    const Sleep *sleep = this->sleep();
    return m_at.phase == 0 && sleep && sleep->isStill() && !nextInputFrame(m_script, sleep->from());
}

void Track::detectSleep()
{
    if (m_sleeping == Sleeping::never)
        return;
    detectSleepingBlocks();
    const std::optional<CycleDetector::Repetition> repetition =
        m_cycleDetector.check(m_now, framesPerOutput());
    const std::int64_t period = repetition ? (m_at.frame - repetition->since) / framesPerOutput() : 0;
    const bool fits = period == 1 || static_cast<std::size_t>(period) * byteSize(m_now) <= maxCycleBytes;
    if (!repetition || !fits ||
        nextInputFrame(m_script, repetition->since).value_or(m_at.frame + 1) <= m_at.frame ||
        preventsSleep(m_interval->pipeline, m_now))
        return;
    // Without input, the next cycle repeats the last one. The loop computes the last one again, which had no
    // input, and not the next one, because later input may still change.
    std::vector<std::shared_ptr<const State>> cycle;
    State state = *m_cycleDetector.mark();
    while (static_cast<std::int64_t>(cycle.size()) < period) {
        auto later = std::make_shared<State>(state);
        later->frame += period * framesPerOutput();
        later->pointEvaluations += repetition->evaluations;
        cycle.push_back(std::move(later));
        if (static_cast<std::int64_t>(cycle.size()) < period)
            runOutputStep(state, state.frame + framesPerOutput(), {});
    }
    m_keyframes.add(Sleep(std::move(cycle), framesPerOutput(), repetition->evaluations));
}

void Track::detectSleepingBlocks()
{
    const State *mark = m_cycleDetector.mark();
    if (!m_interval->pipeline.blocks.empty() && mark && mark->frame + framesPerOutput() == m_at.frame &&
        m_intervals.areInSameInterval(mark->frame, m_at.frame))
        m_blockDetector.check(m_interval->pipeline, *mark, m_now);
}

bool Track::skipSleep(std::int64_t frame)
{
    const Sleep *sleep = sleepAt(m_at.frame);
    const std::int64_t target = sleep ? std::min(frame, lastFrameOf(*sleep)) : m_at.frame;
    if (target <= m_at.frame)
        return false;
    sleep->take(m_now, target);
    m_at = {target, 0};
    m_interval = intervalAt(target);
    m_computed = std::max(m_computed, target);
    return true;
}

}
