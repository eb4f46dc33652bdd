#include "sim/cost/stretch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {

namespace {

constexpr std::size_t cacheBytes = 24 << 10; ///< of the lanes: less than the first cache of any desktop
constexpr int mostLanes = 24;
constexpr int mostRows = 64;
constexpr double sampleSeconds = 400e-6;

void beginRow(State &state, const Pipeline &pipeline)
{
    state.frame += pipeline.step.rowFrames;
    state.outside.gust.reset(); // for one row only
    state.outside.newTargets.clear();
}

/// Returns false when `goesOn` said no.
bool runRow(State &state, const Pipeline &pipeline, const GoesOn &goesOn)
{
    beginRow(state, pipeline);
    for (int step = 0; step < pipeline.step.perRow; ++step) {
        for (const Phase &phase : pipeline.phases) {
            if (goesOn && !goesOn())
                return false;
            phase.run(state);
        }
    }
    return true;
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

Stretch::Stretch(State from, Clock clock)
    : m_clock(std::move(clock)), m_reading(readingOf(m_clock)), m_starts{std::move(from)}
{
}

bool Stretch::choose(const Pipeline &pipeline, const GoesOn &goesOn)
{
    State state = m_starts.front();
    if (!runRow(state, pipeline, goesOn)) // the first one finds nothing in the caches
        return false;
    const double before = m_clock();
    if (!runRow(state, pipeline, goesOn))
        return false;
    const double seconds = std::max(m_clock() - before, 1e-9);
    const double rows = std::clamp(sampleSeconds / seconds, 1.0, double(mostLanes) * mostRows);
    const std::size_t fit = cacheBytes / memoryOf(state);
    const auto lanes =
        std::clamp<std::size_t>(fit, 1, static_cast<std::size_t>(std::min<double>(rows, mostLanes)));
    m_rows = std::clamp(static_cast<int>(rows / static_cast<double>(lanes)), 1, mostRows);
    while (m_starts.size() < lanes) {
        state = m_starts.back();
        if (!runRow(state, pipeline, goesOn))
            return false;
        if (firstNotFinite(state) >= 0)
            break;
        m_starts.push_back(state);
    }
    state = m_starts.back();
    for (int row = 0; row < m_rows;
         ++row) { // what is measured is what a learner sees: it ends where a run does
        if (!runRow(state, pipeline, goesOn))
            return false;
        if (firstNotFinite(state) >= 0)
            m_rows = std::max(1, row);
    }
    return true;
}

std::optional<double> Stretch::timeFrames(const Pipeline &pipeline, const GoesOn &goesOn)
{
    restore();
    double total = 0.0;
    for (int row = 0; row < m_rows; ++row) {
        if (goesOn && !goesOn())
            return {};
        const double before = m_clock();
        for (State &state : m_lanes)
            runRow(state, pipeline, nullptr);
        total += m_clock() - before - m_reading;
    }
    return total / rowsRun();
}

std::optional<PhaseTimes> Stretch::timePhases(const Pipeline &pipeline, const GoesOn &goesOn)
{
    restore();
    const std::size_t phases = pipeline.phases.size();
    PhaseTimes times{std::vector<double>(phases, 0.0), std::vector<double>(phases, 0.0)};
    const auto timed = [&](const std::function<void(State &)> &work) {
        const double before = m_clock();
        for (State &state : m_lanes)
            work(state);
        return m_clock() - before - m_reading;
    };
    for (int row = 0; row < m_rows; ++row) {
        for (State &state : m_lanes)
            beginRow(state, pipeline);
        for (int step = 0; step < pipeline.step.perRow; ++step) {
            for (std::size_t i = 0; i < phases; ++i) {
                if (goesOn && !goesOn())
                    return {};
                const Phase &phase = pipeline.phases[i];
                if (phase.prelude)
                    times.prelude[i] += timed(phase.prelude) / rowsRun();
                times.run[i] += timed(phase.run) / rowsRun();
            }
        }
    }
    return times;
}

}
