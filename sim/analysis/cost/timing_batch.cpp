#include "sim/analysis/cost/timing_batch.h"
#include "sim/run/finite.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {

namespace {

/// For all lanes, less than the first-level cache of any desktop.
constexpr std::size_t cacheBytes = 24 << 10;
constexpr int maxLanes = 24;
constexpr int maxOutputSteps = 64;
constexpr double sampleSeconds = 150e-6; ///< short enough that other programs rarely interrupt it
constexpr double shortStep = 90e-9; ///< s, some hundred instructions, as many as a processor executes at once
constexpr double maxReadingShare = 0.05; ///< of the measured time; below it the CPU clock is used

void beginOutputStep(State &state, const Pipeline &pipeline)
{
    state.frame += pipeline.step.framesPerOutput;
    state.input.gust.reset(); // lasts one output step
    state.input.newTargets.clear();
}

/// Runs all phases of an output step that has begun. Returns false when `shouldContinue` returned false.
bool runPhases(State &state, const Pipeline &pipeline, const ShouldContinue &shouldContinue)
{
    for (int step = 0; step < pipeline.step.stepsPerOutput; ++step) {
        for (const Phase &phase : pipeline.phases) {
            if (shouldContinue && !shouldContinue())
                return false;
            phase.run(state);
        }
    }
    return true;
}

bool runOutputStep(State &state, const Pipeline &pipeline, const ShouldContinue &shouldContinue)
{
    beginOutputStep(state, pipeline);
    return runPhases(state, pipeline, shouldContinue);
}

/// Returns the output steps in which every island takes at least one step of an adaptive method, about two of the present
/// length. Between two steps, frames only read off positions, and no effect is computed. Returns 0 for other methods.
int outputStepsOfAdaptive(const State &state, const StepSize &size)
{
    double longest = 0.0; // frames
    for (const AdaptiveStep &step : state.adaptiveSteps)
        longest = std::max({longest, step.end - step.start, step.nextLength});
    return std::min(maxOutputSteps, static_cast<int>(std::ceil(2.0 * longest / size.framesPerOutput)));
}

double readingOf(const Clock &clock)
{
    std::vector<double> gaps;
    for (int i = 0; i < 51; ++i) {
        const double before = clock();
        gaps.push_back(clock() - before);
    }
    std::nth_element(gaps.begin(), gaps.begin() + 25, gaps.end());
    return gaps[25];
}

}

TimingBatch::TimingBatch(State from, Clocks clocks) : m_clocks(std::move(clocks)), m_starts{std::move(from)}
{
    useClock(m_clocks.wall);
}

void TimingBatch::useClock(const Clock &clock)
{
    m_clock = clock;
    m_reading = readingOf(clock);
}

bool TimingBatch::choose(const Pipeline &pipeline, const ShouldContinue &shouldContinue)
{
    State state = m_starts.front();
    if (!runOutputStep(state, pipeline, shouldContinue)) // the first run has cold caches
        return false;
    const double before = m_clock();
    if (!runOutputStep(state, pipeline, shouldContinue))
        return false;
    const double seconds = std::max(m_clock() - before, 1e-9);
    const double outputSteps = std::clamp(sampleSeconds / seconds, 1.0, double(maxLanes) * maxOutputSteps);
    const std::size_t fit = cacheBytes / byteSize(state);
    const auto lanes =
        std::clamp<std::size_t>(fit, 1, static_cast<std::size_t>(std::min<double>(outputSteps, maxLanes)));
    m_outputSteps = std::clamp(static_cast<int>(outputSteps / static_cast<double>(lanes)),
                               std::max(1, outputStepsOfAdaptive(state, pipeline.step)), maxOutputSteps);
    while (m_starts.size() < lanes) {
        state = m_starts.back();
        if (!runOutputStep(state, pipeline, shouldContinue))
            return false;
        if (firstNonFinitePoint(state) >= 0)
            break;
        m_starts.push_back(state);
    }
    state = m_starts.back();
    // Only finite states are measured, because a run stops at others.
    for (int outputStep = 0; outputStep < m_outputSteps; ++outputStep) {
        if (!runOutputStep(state, pipeline, shouldContinue))
            return false;
        if (firstNonFinitePoint(state) >= 0)
            m_outputSteps = std::max(1, outputStep);
    }
    const std::optional<double> frameSeconds = timeFrames(pipeline, shouldContinue);
    if (!frameSeconds)
        return false;
    const double step = *frameSeconds / pipeline.step.stepsPerOutput;
    m_isShort = step < shortStep;
    const double phaseSeconds = step * static_cast<double>(m_starts.size()) / pipeline.phasesPerStep();
    if (readingOf(m_clocks.threadCpu) < maxReadingShare * phaseSeconds)
        useClock(m_clocks.threadCpu);
    return true;
}

template <class Work>
double TimingBatch::timed(Work &&work)
{
    const double before = m_clock();
    for (State &state : m_lanes)
        work(state);
    return (m_clock() - before - m_reading) / outputStepsRun();
}

std::optional<double> TimingBatch::timeFrames(const Pipeline &pipeline, const ShouldContinue &shouldContinue)
{
    restore();
    double total = 0.0;
    for (int outputStep = 0; outputStep < m_outputSteps; ++outputStep) {
        if (shouldContinue && !shouldContinue())
            return {};
        for (State &state : m_lanes)
            beginOutputStep(state, pipeline);
        total += timed([&](State &state) { runPhases(state, pipeline, nullptr); });
    }
    return total;
}

std::optional<PhaseTimes> TimingBatch::timePhases(const Pipeline &pipeline,
                                                  const ShouldContinue &shouldContinue)
{
    std::optional<PhaseTimes> times = timeEachPhase(pipeline, shouldContinue);
    if (!m_isShort || !times)
        return times;
    double before = 0.0;
    for (std::size_t i = 0; i < pipeline.phases.size(); ++i) {
        const std::optional<double> upTo = timeThroughPhase(i, pipeline, shouldContinue);
        if (!upTo)
            return {};
        times->run[i] = *upTo - before;
        before = *upTo;
    }
    return times;
}

std::optional<PhaseTimes> TimingBatch::timeEachPhase(const Pipeline &pipeline,
                                                     const ShouldContinue &shouldContinue)
{
    restore();
    const std::size_t phases = pipeline.phases.size();
    PhaseTimes times{std::vector<double>(phases, 0.0), std::vector<double>(phases, 0.0)};
    for (int outputStep = 0; outputStep < m_outputSteps; ++outputStep) {
        for (State &state : m_lanes)
            beginOutputStep(state, pipeline);
        for (int step = 0; step < pipeline.step.stepsPerOutput; ++step) {
            for (std::size_t i = 0; i < phases; ++i) {
                if (shouldContinue && !shouldContinue())
                    return {};
                const Phase &phase = pipeline.phases[i];
                if (phase.kernels.size() > 1)
                    times.prelude[i] += timed([&](State &state) { phase.prepare(state); });
                times.run[i] += timed([&](State &state) { phase.run(state); });
            }
        }
    }
    return times;
}

std::optional<double> TimingBatch::timeThroughPhase(std::size_t last, const Pipeline &pipeline,
                                                    const ShouldContinue &shouldContinue)
{
    restore();
    const auto middle = pipeline.phases.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    double total = 0.0;
    for (int outputStep = 0; outputStep < m_outputSteps; ++outputStep) {
        if (shouldContinue && !shouldContinue())
            return {};
        for (State &state : m_lanes)
            beginOutputStep(state, pipeline);
        for (int step = 0; step < pipeline.step.stepsPerOutput; ++step) {
            total += timed([&](State &state) {
                for (auto phase = pipeline.phases.begin(); phase != middle; ++phase)
                    phase->run(state);
            });
            for (State &state : m_lanes) {
                for (auto phase = middle; phase != pipeline.phases.end(); ++phase)
                    phase->run(state);
            }
        }
    }
    return total;
}

}
