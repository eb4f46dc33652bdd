#include "sim/catalogue/judge.h"

#include "sim/analysis/accuracy/study_run.h"
#include "sim/analysis/stability/remedies/stick_fit.h"
#include "sim/run/script/composed_interval.h"

#include <cmath>
#include <sstream>

namespace sim {

namespace {

std::string text(double value)
{
    std::ostringstream stream;
    stream.precision(3);
    stream << value;
    return stream.str();
}

const std::string &nameOf(const Scene &scene, int point)
{
    return scene.names[static_cast<std::size_t>(point)];
}

/// The middle of all masses that move; NaN where nothing does.
Vec2 middleOf(const State &state)
{
    Vec2 sum;
    double mass = 0.0;
    for (int i = 0; i < state.pointCount(); ++i) {
        if (!state.isDynamic(i))
            continue;
        sum = sum + (1.0 / state.inverseMass[i]) * state.positionOf(i);
        mass += 1.0 / state.inverseMass[i];
    }
    return (1.0 / mass) * sum;
}

/// What is looked at after each row.
class BoundsChecker
{
public:
    BoundsChecker(const HardCase &hard, const Scene &scene) : m_hard(hard), m_from(middleOf(scene.start)) {}

    std::optional<Error> look(const Scene &scene, const State &state, std::int64_t frame) const
    {
        const std::string when = std::to_string(frame);
        for (int i = 0; i < state.pointCount(); ++i) {
            if (!(length(state.positionOf(i) - m_hard.bound.from) <= m_hard.bound.reach))
                return Error(
                    "hard-too-far",
                    {{"frame", when}, {"body", nameOf(scene, i)}, {"reach", text(m_hard.bound.reach)}});
        }
        if (m_hard.bound.drift) {
            const double drift = length(middleOf(state) - m_from);
            if (!(drift <= *m_hard.bound.drift))
                return Error("hard-drifts", {{"frame", when}, {"drift", text(drift)}});
        }
        return m_hard.stickError ? lookAtSticks(scene, state, when) : std::nullopt;
    }

private:
    std::optional<Error> lookAtSticks(const Scene &scene, const State &state, const std::string &when) const
    {
        const StickFit worst = worstStick(scene, state);
        if (worst.a < 0 || std::abs(worst.error) <= *m_hard.stickError)
            return {};
        return Error("hard-stick", {{"frame", when},
                                    {"a", nameOf(scene, worst.a)},
                                    {"b", nameOf(scene, worst.b)},
                                    {"error", text(std::abs(worst.error))},
                                    {"most", text(*m_hard.stickError)}});
    }

    const HardCase &m_hard;
    Vec2 m_from;
};

/// What is wrong with the end of a run that should be at rest. `rowFrames`: since `before`. What a method calls a
/// velocity at the end of a step may be one half way; so it is places that tell.
std::optional<Error> lookAtRest(const Rest &rest, const Scene &scene, const State &before, const State &state,
                                int framesPerOutput)
{
    for (int i = 0; i < state.pointCount(); ++i) {
        const double speed = length(state.positionOf(i) - before.positionOf(i)) / framesPerOutput;
        if (!(speed <= rest.speed))
            return Error("hard-moves", {{"body", nameOf(scene, i)}, {"speed", text(speed)}});
    }
    for (const RestPosition &place : rest.places) {
        const double off = length(state.positionOf(scene.find(place.body)) - place.x);
        if (!(off <= place.within))
            return Error("hard-elsewhere", {{"body", place.body}, {"off", text(off)}});
    }
    for (const RestDistance &wanted : rest.distances) {
        const Vec2 apart = state.positionOf(scene.find(wanted.a)) - state.positionOf(scene.find(wanted.b));
        const double off = std::abs(length(apart) - wanted.length);
        if (!(off <= wanted.within))
            return Error("hard-length", {{"a", wanted.a}, {"b", wanted.b}, {"off", text(off)}});
    }
    return {};
}

/// Asks now and then whether to go on.
class ProgressReporter
{
public:
    explicit ProgressReporter(const JudgeProgress &progress) : m_progress(progress) {}
    bool goesOn(double share)
    {
        if (m_progress && Clock::now() >= m_next) {
            m_ends = m_ends || !m_progress(share);
            m_next = Clock::now() + std::chrono::milliseconds(50);
        }
        return !m_ends;
    }

private:
    using Clock = std::chrono::steady_clock;
    const JudgeProgress &m_progress;
    Clock::time_point m_next = Clock::now();
    bool m_ends = false;
};

Error whyItStopped(const Stop &stop)
{
    const std::string frame = std::to_string(stop.frame);
    if (stop.reason == StopReason::tooManySteps)
        return Error("hard-too-many-steps", {{"frame", frame}});
    return Error("hard-not-finite", {{"frame", frame}, {"body", stop.body}, {"phase", stop.phase}});
}

/// The first run: looks at every row. Returns the state it ends with.
State watchedRun(const HardCase &hard, const Script &script, const RunSize &size, ProgressReporter &onlooker,
                 Verdict &verdict)
{
    const std::int64_t frames = size.frames;
    Track track(script, 0);
    const BoundsChecker watcher(hard, track.interval().scene);
    const double whole = static_cast<double>(frames);
    State before = track.state();
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames && !verdict.why;
         frame += track.framesPerOutput()) {
        if (!onlooker.goesOn(0.5 * static_cast<double>(frame) / whole)) {
            verdict.isComplete = false;
            return track.state();
        }
        if (frame + track.framesPerOutput() > frames)
            before = track.state();
        track.seek({frame, 0});
        if (const std::optional<Stop> &stop = track.stop()) {
            verdict.why = whyItStopped(*stop);
            break;
        }
        verdict.frames = frame;
        verdict.why = watcher.look(track.interval().scene, track.state(), frame);
    }
    if (const Rest *rest = hard.restAfter(size); rest && !verdict.why)
        verdict.why =
            lookAtRest(*rest, track.interval().scene, before, track.state(), track.framesPerOutput());
    return track.state();
}

/// The second run: under a clock, in stretches of some milliseconds, and looked at only in the end.
void repeatedRun(const Script &script, const State &end, ProgressReporter &onlooker, Verdict &verdict)
{
    Track track(script, 0, Sleeping::never); // as what is asleep costs nothing
    const double whole = static_cast<double>(verdict.frames);
    double seconds = 0.0;
    std::int64_t stretch = track.framesPerOutput();
    for (std::int64_t frame = 0; frame < verdict.frames;) {
        if (!onlooker.goesOn(0.5 + 0.5 * static_cast<double>(frame) / whole)) {
            verdict.isComplete = false;
            return;
        }
        frame = std::min(verdict.frames, frame + stretch);
        const double before = threadCpuSeconds();
        track.seek({frame, 0});
        const double took = threadCpuSeconds() - before;
        seconds += took;
        stretch *= took < 0.01 ? 2 : 1;
    }
    if (verdict.frames > 0)
        verdict.nsPerFrame = 1e9 * seconds / whole;
    if (!verdict.why && !sameBits(track.state(), end))
        verdict.why = Error("hard-not-the-same", {{"frame", std::to_string(verdict.frames)}});
}

/// Only a refusal of the right kind is right.
void judgeRefusal(const HardCase &hard, const Script &script, Verdict &verdict)
{
    const std::optional<Error> refusal = composeError(script);
    verdict.holds = refusal && refusal->id() == hard.refusal;
    if (!verdict.holds)
        verdict.why = refusal ? *refusal : Error("hard-not-refused", {});
}

/// A run that has to end: on a finite frame, saying where and why.
void judgeEnd(Verdict &verdict)
{
    const bool ended = verdict.why && verdict.why->id() == "hard-not-finite";
    verdict.holds = ended && !verdict.why->values().at("body").empty();
    if (verdict.holds)
        verdict.why.reset();
    else if (!verdict.why)
        verdict.why = Error("hard-does-not-end", {});
}

}

std::optional<Error> findViolation(const HardCase &hard, const Scene &first, const Scene &scene,
                                   const State &state, std::int64_t frame)
{
    return BoundsChecker(hard, first).look(scene, state, frame);
}

std::optional<Error> findRestViolation(const HardCase &hard, const Scene &scene, const State &before,
                                       const State &state, int framesPerOutput)
{
    return hard.rest ? lookAtRest(*hard.rest, scene, before, state, framesPerOutput) : std::nullopt;
}

Verdict judge(const HardCase &hard, const MethodPtr &method, const RunSize &size,
              const JudgeProgress &progress)
{
    Verdict verdict;
    verdict.claim = claimOf(hard, method, size);
    const Script script = scriptOf(hard, method, size);
    if (hard.hasRequirement(Requirement::refused)) {
        judgeRefusal(hard, script, verdict);
        return verdict;
    }
    if (const std::optional<Error> misfit = composeError(script)) {
        verdict.why = misfit;
        return verdict;
    }
    ProgressReporter onlooker(progress);
    const State end = watchedRun(hard, script, size, onlooker, verdict);
    if (verdict.isComplete)
        repeatedRun(script, end, onlooker, verdict);
    if (hard.hasRequirement(Requirement::overflows))
        judgeEnd(verdict);
    else
        verdict.holds = verdict.isComplete && !verdict.why;
    return verdict;
}

}
