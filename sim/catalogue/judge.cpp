#include "sim/catalogue/judge.h"

#include "sim/analysis/accuracy/study_run.h"
#include "sim/analysis/stability/remedies/stick_fit.h"
#include "sim/catalogue/number_text.h"
#include "sim/run/script/composed_interval.h"

#include <cmath>

namespace sim {

namespace {

const std::string &nameOf(const Scene &scene, int point)
{
    return scene.names[static_cast<std::size_t>(point)];
}

/// Returns the centre of mass of the dynamic points (px); NaN if there is none.
Vec2 centreOfMass(const State &state)
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

/// Checks the bounds of a case after each output step.
class BoundsChecker
{
public:
    BoundsChecker(const HardCase &hardCase, const Scene &scene)
        : m_hardCase(hardCase), m_start(centreOfMass(scene.start))
    {
    }

    std::optional<Error> check(const Scene &scene, const State &state, std::int64_t frame) const
    {
        const std::string when = std::to_string(frame);
        for (int i = 0; i < state.pointCount(); ++i) {
            if (!(length(state.positionOf(i) - m_hardCase.bound.from) <= m_hardCase.bound.reach))
                return Error("hard-too-far", {{"frame", when},
                                              {"body", nameOf(scene, i)},
                                              {"reach", numberText(m_hardCase.bound.reach)}});
        }
        if (m_hardCase.bound.drift) {
            const double drift = length(centreOfMass(state) - m_start);
            if (!(drift <= *m_hardCase.bound.drift))
                return Error("hard-drifts", {{"frame", when}, {"drift", numberText(drift)}});
        }
        return m_hardCase.stickError ? checkSticks(scene, state, when) : std::nullopt;
    }

private:
    std::optional<Error> checkSticks(const Scene &scene, const State &state, const std::string &when) const
    {
        const StickFit worst = worstStick(scene, state);
        if (worst.a < 0 || std::abs(worst.error) <= *m_hardCase.stickError)
            return {};
        return Error("hard-stick", {{"frame", when},
                                    {"a", nameOf(scene, worst.a)},
                                    {"b", nameOf(scene, worst.b)},
                                    {"error", numberText(std::abs(worst.error))},
                                    {"most", numberText(*m_hardCase.stickError)}});
    }

    const HardCase &m_hardCase;
    Vec2 m_start;
};

/// See findRestViolation(). It compares positions instead of reading velocities, because some methods store
/// the velocity at the middle of a step.
std::optional<Error> checkRest(const Rest &rest, const Scene &scene, const State &before, const State &state,
                               int framesPerOutput)
{
    for (int i = 0; i < state.pointCount(); ++i) {
        const double speed = length(state.positionOf(i) - before.positionOf(i)) / framesPerOutput;
        if (!(speed <= rest.speed))
            return Error("hard-moves", {{"body", nameOf(scene, i)}, {"speed", numberText(speed)}});
    }
    for (const RestPosition &expected : rest.places) {
        const double difference = length(state.positionOf(scene.find(expected.body)) - expected.x);
        if (!(difference <= expected.within))
            return Error("hard-elsewhere", {{"body", expected.body}, {"off", numberText(difference)}});
    }
    const auto checkDistance = [&](const RestDistance &expected) -> std::optional<Error> {
        const Vec2 apart =
            state.positionOf(scene.find(expected.a)) - state.positionOf(scene.find(expected.b));
        const double difference = std::abs(length(apart) - expected.length);
        if (difference <= expected.within)
            return {};
        return Error("hard-length", {{"a", expected.a}, {"b", expected.b}, {"off", numberText(difference)}});
    };
    for (const RestDistance &expected : rest.distances) {
        if (const auto error = checkDistance(expected))
            return error;
    }
    for (int i = 0; i < rest.legs.feet; ++i) {
        const RestLegs &legs = rest.legs;
        if (const auto error = checkDistance({"foot" + std::to_string(i), "body", legs.length, legs.within}))
            return error;
    }
    return {};
}

/// Reports progress at most every 50 ms, and remembers whether judging was cancelled.
class ProgressReporter
{
public:
    explicit ProgressReporter(const JudgeProgress &progress) : m_progress(progress) {}
    bool shouldContinue(double share)
    {
        if (m_progress && Clock::now() >= m_next) {
            m_cancelled = m_cancelled || !m_progress(share);
            m_next = Clock::now() + std::chrono::milliseconds(50);
        }
        return !m_cancelled;
    }

private:
    using Clock = std::chrono::steady_clock;
    const JudgeProgress &m_progress;
    Clock::time_point m_next = Clock::now();
    bool m_cancelled = false;
};

/// Returns the failure of a run that stopped.
Error failureOf(const Stop &stop)
{
    const std::string frame = std::to_string(stop.frame);
    if (stop.reason == StopReason::tooManySteps)
        return Error("hard-too-many-steps", {{"frame", frame}});
    return Error("hard-not-finite", {{"frame", frame}, {"body", stop.body}, {"phase", stop.phase}});
}

/// The first run: checks every output step. Returns the final state.
State checkedRun(const HardCase &hardCase, const Script &script, const RunSize &size,
                 ProgressReporter &reporter, Verdict &verdict)
{
    const std::int64_t frames = size.frames;
    Track track(script, 0);
    const BoundsChecker checker(hardCase, track.interval().scene);
    const double frameCount = static_cast<double>(frames);
    State before = track.state();
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames && !verdict.why;
         frame += track.framesPerOutput()) {
        if (!reporter.shouldContinue(0.5 * static_cast<double>(frame) / frameCount)) {
            verdict.isComplete = false;
            return track.state();
        }
        if (frame + track.framesPerOutput() > frames)
            before = track.state();
        track.seek({frame, 0});
        if (const std::optional<Stop> &stop = track.stop()) {
            verdict.why = failureOf(*stop);
            break;
        }
        verdict.frames = frame;
        verdict.why = checker.check(track.interval().scene, track.state(), frame);
    }
    if (const Rest *rest = hardCase.restAfter(size); rest && !verdict.why)
        verdict.why =
            checkRest(*rest, track.interval().scene, before, track.state(), track.framesPerOutput());
    return track.state();
}

/// The second run: measures the computing time and compares the final state with `end`. It runs in batches of
/// frames. Their size doubles until a batch takes 10 ms.
void repeatedRun(const Script &script, const State &end, ProgressReporter &reporter, Verdict &verdict)
{
    Track track(script, 0, Sleeping::never); // sleeping would hide the cost
    const double frameCount = static_cast<double>(verdict.frames);
    double seconds = 0.0;
    std::int64_t batch = track.framesPerOutput();
    for (std::int64_t frame = 0; frame < verdict.frames;) {
        if (!reporter.shouldContinue(0.5 + 0.5 * static_cast<double>(frame) / frameCount)) {
            verdict.isComplete = false;
            return;
        }
        frame = std::min(verdict.frames, frame + batch);
        const double before = threadCpuSeconds();
        track.seek({frame, 0});
        const double elapsed = threadCpuSeconds() - before;
        seconds += elapsed;
        batch *= elapsed < 0.01 ? 2 : 1;
    }
    if (verdict.frames > 0)
        verdict.nsPerFrame = 1e9 * seconds / frameCount;
    if (!verdict.why && !sameBits(track.state(), end))
        verdict.why = Error("hard-not-the-same", {{"frame", std::to_string(verdict.frames)}});
}

/// Passes if the script is rejected with the expected error.
void judgeRejection(const HardCase &hardCase, const Script &script, Verdict &verdict)
{
    const std::optional<Error> error = composeError(script);
    verdict.holds = error && error->id() == hardCase.expectedError;
    if (!verdict.holds)
        verdict.why = error ? *error : Error("hard-not-refused", {});
}

/// Passes if the run ended because of a number that is not finite, and the failure names a body.
void judgeOverflow(Verdict &verdict)
{
    const bool ended = verdict.why && verdict.why->id() == "hard-not-finite";
    verdict.holds = ended && !verdict.why->values().at("body").empty();
    if (verdict.holds)
        verdict.why.reset();
    else if (!verdict.why)
        verdict.why = Error("hard-does-not-end", {});
}

}

std::optional<Error> findViolation(const HardCase &hardCase, const Scene &first, const Scene &scene,
                                   const State &state, std::int64_t frame)
{
    return BoundsChecker(hardCase, first).check(scene, state, frame);
}

std::optional<Error> findRestViolation(const HardCase &hardCase, const Scene &scene, const State &before,
                                       const State &state, int framesPerOutput)
{
    return hardCase.rest ? checkRest(*hardCase.rest, scene, before, state, framesPerOutput) : std::nullopt;
}

Verdict judge(const HardCase &hardCase, const MethodPtr &method, const RunSize &size,
              const JudgeProgress &progress)
{
    Verdict verdict;
    verdict.claim = claimOf(hardCase, method, size);
    const Script script = scriptOf(hardCase, method, size);
    if (hardCase.hasRequirement(Requirement::rejected)) {
        judgeRejection(hardCase, script, verdict);
        return verdict;
    }
    if (const std::optional<Error> error = composeError(script)) {
        verdict.why = error;
        return verdict;
    }
    ProgressReporter reporter(progress);
    const State end = checkedRun(hardCase, script, size, reporter, verdict);
    if (verdict.isComplete)
        repeatedRun(script, end, reporter, verdict);
    if (hardCase.hasRequirement(Requirement::overflows))
        judgeOverflow(verdict);
    else
        verdict.holds = verdict.isComplete && !verdict.why;
    return verdict;
}

}
