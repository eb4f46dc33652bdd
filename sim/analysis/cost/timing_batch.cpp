#include "sim/analysis/cost/timing_batch.h"
#include "sim/run/finite.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {

namespace {

constexpr std::size_t cacheBytes = 24 << 10; ///< of the lanes: less than the first cache of any desktop
constexpr int mostLanes = 24;
constexpr int mostRows = 64;
constexpr double sampleSeconds = 150e-6; ///< mostly too short for another program to come in between
constexpr double shortStep =
    90e-9; ///< s: some hundred instructions, as many as a processor has under way at once
constexpr double mostReading = 0.05; ///< of what is between two readings, for the patient clock to be used

void beginRow(State &state, const Pipeline &pipeline)
{
    state.frame += pipeline.step.framesPerOutput;
    state.input.gust.reset(); // for one row only
    state.input.newTargets.clear();
}

/// All phases of a row that has begun. Returns false when `goesOn` said no.
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

bool runRow(State &state, const Pipeline &pipeline, const ShouldContinue &shouldContinue)
{
    beginRow(state, pipeline);
    return runPhases(state, pipeline, shouldContinue);
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

TimingBatch::TimingBatch(State from, TimerKind clocks)
    : m_clocks(std::move(clocks)), m_starts{std::move(from)}
{
    read(m_clocks.wall);
}

void TimingBatch::read(const Clock &clock)
{
    m_clock = clock;
    m_reading = readingOf(clock);
}

bool TimingBatch::choose(const Pipeline &pipeline, const ShouldContinue &shouldContinue)
{
    State state = m_starts.front();
    if (!runRow(state, pipeline, shouldContinue)) // the first one finds nothing in the caches
        return false;
    const double before = m_clock();
    if (!runRow(state, pipeline, shouldContinue))
        return false;
    const double seconds = std::max(m_clock() - before, 1e-9);
    const double rows = std::clamp(sampleSeconds / seconds, 1.0, double(mostLanes) * mostRows);
    const std::size_t fit = cacheBytes / byteSize(state);
    const auto lanes =
        std::clamp<std::size_t>(fit, 1, static_cast<std::size_t>(std::min<double>(rows, mostLanes)));
    m_rows = std::clamp(static_cast<int>(rows / static_cast<double>(lanes)), 1, mostRows);
    while (m_starts.size() < lanes) {
        state = m_starts.back();
        if (!runRow(state, pipeline, shouldContinue))
            return false;
        if (firstNonFinitePoint(state) >= 0)
            break;
        m_starts.push_back(state);
    }
    state = m_starts.back();
    for (int row = 0; row < m_rows;
         ++row) { // what is measured is what a learner sees: it ends where a run does
        if (!runRow(state, pipeline, shouldContinue))
            return false;
        if (firstNonFinitePoint(state) >= 0)
            m_rows = std::max(1, row);
    }
    const std::optional<double> found = timeFrames(pipeline, shouldContinue);
    if (!found)
        return false;
    const double step = *found / pipeline.step.stepsPerOutput;
    m_isShort = step < shortStep;
    const double between = step * static_cast<double>(m_starts.size()) / pipeline.phasesPerStep();
    if (readingOf(m_clocks.threadCpu) < mostReading * between)
        read(m_clocks.threadCpu);
    return true;
}

template <class Work>
double TimingBatch::timed(Work &&work)
{
    const double before = m_clock();
    for (State &state : m_lanes)
        work(state);
    return (m_clock() - before - m_reading) / rowsRun();
}

std::optional<double> TimingBatch::timeFrames(const Pipeline &pipeline, const ShouldContinue &shouldContinue)
{
    restore();
    double total = 0.0;
    for (int row = 0; row < m_rows; ++row) {
        if (shouldContinue && !shouldContinue())
            return {};
        for (State &state : m_lanes)
            beginRow(state, pipeline);
        total += timed([&](State &state) { runPhases(state, pipeline, nullptr); });
    }
    return total;
}

std::optional<PhaseTimes> TimingBatch::timePhases(const Pipeline &pipeline,
                                                  const ShouldContinue &shouldContinue)
{
    std::optional<PhaseTimes> times = timeApart(pipeline, shouldContinue);
    if (!m_isShort || !times)
        return times;
    double before = 0.0;
    for (std::size_t i = 0; i < pipeline.phases.size(); ++i) {
        const std::optional<double> upTo = timeUpTo(i, pipeline, shouldContinue);
        if (!upTo)
            return {};
        times->run[i] = *upTo - before;
        before = *upTo;
    }
    return times;
}

std::optional<PhaseTimes> TimingBatch::timeApart(const Pipeline &pipeline,
                                                 const ShouldContinue &shouldContinue)
{
    restore();
    const std::size_t phases = pipeline.phases.size();
    PhaseTimes times{std::vector<double>(phases, 0.0), std::vector<double>(phases, 0.0)};
    for (int row = 0; row < m_rows; ++row) {
        for (State &state : m_lanes)
            beginRow(state, pipeline);
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

std::optional<double> TimingBatch::timeUpTo(std::size_t last, const Pipeline &pipeline,
                                            const ShouldContinue &shouldContinue)
{
    restore();
    const auto middle = pipeline.phases.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    double total = 0.0;
    for (int row = 0; row < m_rows; ++row) {
        if (shouldContinue && !shouldContinue())
            return {};
        for (State &state : m_lanes)
            beginRow(state, pipeline);
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
