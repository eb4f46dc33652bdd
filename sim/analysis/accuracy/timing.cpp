#include "sim/analysis/accuracy/timing.h"

#include "sim/analysis/accuracy/samples.h"
#include "sim/analysis/accuracy/study_run.h"
#include "sim/base/cpu_clock.h"
#include "sim/pipeline/pipeline.h"
#include "sim/scene/scene.h"
#include "sim/simd/flush_denormals.h"

#include <memory>
#include <utility>

namespace sim {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double minSample = 100e-6; ///< s, far longer than reading the clock takes
constexpr double maxSample = 1e-3;   ///< s, short enough that other programs rarely interrupt it
constexpr double longRun = 0.05;     ///< s, from here on the run that measured the error is the first sample
constexpr int maxRuns = 25;
constexpr int minRuns = 2; ///< after the first run, which only chooses the sample sizes

/// Times runs of one method setup from the start of the scene, computed as in the app.
class TimedRun
{
public:
    TimedRun(const Script &script, std::int64_t frames)
        : m_frames(frames), m_chunk(script.step.framesPerOutput)
    {
        const bool hasNoInput = std::all_of(script.input.begin(), script.input.end(),
                                            [&](const Event &event) { return event.frame > frames; });
        if (hasNoInput) {
            const Scene scene = sceneOf(script, script.values);
            m_start = scene.start;
            m_pipeline = compose(scene, *script.method, script.step);
        } else {
            m_track = std::make_unique<Track>(script, 0, Sleeping::never);
        }
    }

    /// Returns the seconds that one run over the first `frames` frames takes. The run is timed in chunks of
    /// some milliseconds. Between two chunks, while the clock is stopped, `monitor` decides whether to
    /// continue.
    double seconds(std::int64_t frames, StudyMonitor &monitor, double share)
    {
        if (m_track)
            m_track->seek({0, 0});
        State state = m_start;
        double total = 0.0;
        for (std::int64_t done = 0; done < frames && monitor.report(share);) {
            const std::int64_t end = std::min(frames, done + m_chunk);
            const double before = m_usesCpuClock ? threadCpuSeconds() : wallSeconds();
            if (m_track)
                m_track->seek({end, 0}); // applies the input
            else
                runTo(end, state, done);
            const double chunkSeconds = (m_usesCpuClock ? threadCpuSeconds() : wallSeconds()) - before;
            total += chunkSeconds;
            done = end;
            if (chunkSeconds < 0.01 && m_chunk < m_frames)
                m_chunk *= 2;
        }
        m_usesCpuClock = total > minSample;
        return total;
    }
    std::int64_t frames() const { return m_frames; }

private:
    void runTo(std::int64_t end, State &state, std::int64_t done) const
    {
        const FlushDenormals flush;
        const int framesPerOutput = m_pipeline.step.framesPerOutput;
        for (std::int64_t frame = done + framesPerOutput; frame <= end; frame += framesPerOutput) {
            state.frame = frame;
            for (int step = 0; step < m_pipeline.step.stepsPerOutput; ++step) {
                for (const StepKernel &kernel : m_pipeline.kernels)
                    kernel.kernel.run(state);
            }
        }
    }

    std::int64_t m_frames;
    std::int64_t m_chunk; ///< frames, short enough to stop soon and long enough to time
    /// Whether runs are so long that other programs interrupt them. The CPU clock is slower to read but
    /// ignores these.
    bool m_usesCpuClock = false;
    State m_start;
    Pipeline m_pipeline;
    std::unique_ptr<Track> m_track;
};

/// A row, its timed run and the samples taken.
struct Sampled
{
    AccuracyRow *row;
    TimedRun run;
    std::int64_t frames = 0; ///< per run
    int repeats = 1;         ///< runs per sample
    Samples samples = {};    ///< ns per frame
    bool isLong = false;     ///< whether a run is long and cannot be shortened

    /// Takes one sample and returns its ns per frame.
    double sample(StudyMonitor &monitor, double share)
    {
        double total = 0.0;
        for (int i = 0; i < repeats && !monitor.isStopped(); ++i)
            total += run.seconds(frames, monitor, share);
        return 1e9 * total / (static_cast<double>(frames) * repeats);
    }
};

void updateRow(Sampled &sampled)
{
    sampled.row->nsPerFrame = sampled.samples.median();
    sampled.row->spread = sampled.samples.spread();
}

/// Returns the median of spread / nsPerFrame over all rows; see Accuracy::noise.
double noiseOf(const std::vector<Sampled> &all)
{
    Samples shares;
    for (const Sampled &one : all)
        shares.add(one.row->spread / one.row->nsPerFrame);
    return shares.median();
}

class Timing
{
public:
    Timing(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor)
        : m_plan(plan), m_found(found), m_monitor(monitor)
    {
        for (AccuracyRow &row : found.rows) {
            if (row.outcome == Outcome::measured)
                m_all.push_back({&row, TimedRun(scriptFor(script, row.setup), found.horizon)});
        }
    }

    void measure()
    {
        double round = 0.0; // seconds
        for (std::size_t i = 0; i < m_all.size() && m_monitor.report(0.1 * shareOf(i)); ++i)
            round += chooseSampleLength(m_all[i], 0.1 * shareOf(i));
        m_repeatsLong = m_secondsOfLong * minRuns <= m_plan.secondsOfTiming;
        round -= m_repeatsLong ? 0.0 : m_secondsOfLong;
        const auto start = Clock::now();
        for (int runs = 0; runs < maxRuns && !m_monitor.isStopped(); ++runs) {
            const double spent = std::chrono::duration<double>(Clock::now() - start).count();
            const bool isOverBudget = spent + round > m_plan.secondsOfTiming;
            const bool isFarOverBudget = spent + round > 2.0 * m_plan.secondsOfTiming;
            if (runs >= minRuns && isOverBudget && (runs >= m_plan.leastRuns || isFarOverBudget))
                break;
            runRound(runs, std::max(spent / m_plan.secondsOfTiming, double(runs) / maxRuns));
        }
        if (!m_monitor.isStopped())
            m_found.noise = noiseOf(m_all);
    }

private:
    double shareOf(std::size_t i) const { return static_cast<double>(i) / static_cast<double>(m_all.size()); }

    /// Chooses the length of a sample. A long run at fixed steps is shortened, because each of its frames
    /// costs the same. An adaptive run is not. Returns the seconds that a sample takes.
    double chooseSampleLength(Sampled &one, double share)
    {
        one.frames = one.run.frames();
        const double first = 1e-9 * one.row->firstRun * static_cast<double>(one.frames);
        if (one.row->setup.step.isAdaptive() && first > longRun) {
            one.isLong = true;
            one.samples.add(one.row->firstRun);
            updateRow(one);
            m_secondsOfLong += first;
            return first;
        }
        double runSeconds = one.run.seconds(one.frames, m_monitor, share);
        if (runSeconds < minSample) // again, because the first run started with cold caches
            runSeconds = std::max(1e-9, one.run.seconds(one.frames, m_monitor, share));
        const double maxSeconds = std::min(
            maxSample, m_plan.secondsOfTiming / (m_plan.leastRuns * static_cast<double>(m_all.size())));
        double expected = runSeconds;
        if (runSeconds > maxSeconds && !one.row->setup.step.isAdaptive()) {
            const int framesPerOutput = one.row->setup.step.framesPerOutput;
            const auto frames =
                static_cast<std::int64_t>(static_cast<double>(one.frames) * maxSeconds / runSeconds);
            one.frames = std::max<std::int64_t>(1, frames / framesPerOutput) * framesPerOutput;
            expected = runSeconds * static_cast<double>(one.frames) / static_cast<double>(one.run.frames());
        }
        one.repeats = static_cast<int>(std::ceil(std::max(1.0, minSample / expected)));
        if (runSeconds > maxSample && !m_monitor.isStopped()) { // a long run is already a good sample
            one.samples.add(1e9 * runSeconds / static_cast<double>(one.run.frames()));
            updateRow(one);
        }
        return expected * one.repeats;
    }

    /// Takes one sample per row. Each round starts at another row and every second round goes backwards, so
    /// no row always follows the same one.
    void runRound(int round, double share)
    {
        const std::size_t count = m_all.size();
        const double progress = 0.1 + 0.9 * std::min(1.0, share);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t step = round % 2 == 0 ? i : count - 1 - i;
            Sampled &one = m_all[(step + static_cast<std::size_t>(round) * 7) % count];
            if (one.isLong && !m_repeatsLong)
                continue;
            const double ns = one.sample(m_monitor, progress);
            if (m_monitor.isStopped())
                return;
            one.samples.add(ns);
            updateRow(one);
        }
        markFront(m_found.rows);
    }

    const StudyPlan &m_plan;
    Accuracy &m_found;
    StudyMonitor &m_monitor;
    std::vector<Sampled> m_all;
    double m_secondsOfLong = 0.0; ///< s, one run of each long row
    bool m_repeatsLong = false;   ///< whether there is time to repeat the long runs
};

}

void measureTimes(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor)
{
    Timing(script, plan, found, monitor).measure();
}

}
