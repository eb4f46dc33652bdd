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

constexpr double shortestSample = 100e-6; ///< s: far above what reading the clock takes
constexpr double longestSample = 1e-3;    ///< s: mostly too short for another program to come in between
constexpr double dearRun = 0.05;          ///< s: from here on the run that told the error is the first sample
constexpr int mostRuns = 25;
constexpr int fewestMoreRuns = 2; ///< after the first one, in which the sizes of samples are chosen

/// Runs one way from the scene's start as the app does, under a clock.
class TimedRun
{
public:
    TimedRun(const Script &script, std::int64_t frames)
        : m_frames(frames), m_stretch(script.step.framesPerOutput)
    {
        const bool isLeftAlone = std::all_of(script.input.begin(), script.input.end(),
                                             [&](const Event &event) { return event.frame > frames; });
        if (isLeftAlone) {
            const Scene scene = sceneOf(script, script.values);
            m_start = scene.start;
            m_pipeline = compose(scene, *script.method, script.step);
        } else {
            m_track = std::make_unique<Track>(script, 0, Sleeping::never);
        }
    }

    /// The seconds of computing that one run over the first `frames` frames takes. Between stretches of some milliseconds, while
    /// the clock stands, `watch` is asked whether to go on.
    double seconds(std::int64_t frames, StudyMonitor &monitor, double share)
    {
        if (m_track)
            m_track->seek({0, 0});
        State state = m_start;
        double total = 0.0;
        for (std::int64_t done = 0; done < frames && monitor.report(share);) {
            const std::int64_t end = std::min(frames, done + m_stretch);
            const double before = m_isLong ? threadCpuSeconds() : wallSeconds();
            if (m_track)
                m_track->seek({end, 0}); // with the input of each row
            else
                runTo(end, state, done);
            const double took = (m_isLong ? threadCpuSeconds() : wallSeconds()) - before;
            total += took;
            done = end;
            if (took < 0.01 && m_stretch < m_frames)
                m_stretch *= 2;
        }
        m_isLong = total > shortestSample;
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
    std::int64_t m_stretch; ///< frames; short enough to be asked often, long enough not to be noticed
    bool m_isLong =
        false; ///< so that other programs may come in between, and the dearer clock is worth its price
    State m_start;
    Pipeline m_pipeline;
    std::unique_ptr<Track> m_track;
};

/// A row, how it is run, and what that took.
struct Sampled
{
    AccuracyRow *row;
    TimedRun run;
    std::int64_t frames = 0;          ///< a run
    int repeats = 1;                  ///< runs a sample
    std::vector<double> samples = {}; ///< ns a frame
    bool isDear = false;              ///< runs that are long, and can not be cut

    /// ns a frame.
    double sample(StudyMonitor &monitor, double share)
    {
        double total = 0.0;
        for (int i = 0; i < repeats && !monitor.isStopped(); ++i)
            total += run.seconds(frames, monitor, share);
        return 1e9 * total / (static_cast<double>(frames) * repeats);
    }
};

void note(Sampled &sampled)
{
    std::vector<double> sorted = sampled.samples;
    std::sort(sorted.begin(), sorted.end());
    sampled.row->nsPerFrame = quantile(sorted, 0.5);
    sampled.row->spread = 0.5 * (quantile(sorted, 0.75) - quantile(sorted, 0.25));
}

double noiseOf(const std::vector<Sampled> &all)
{
    std::vector<double> shares;
    for (const Sampled &one : all)
        shares.push_back(one.row->spread / one.row->nsPerFrame);
    std::sort(shares.begin(), shares.end());
    return shares.empty() ? 0.0 : quantile(shares, 0.5);
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
            round += size(m_all[i], 0.1 * shareOf(i));
        m_repeatsDear = m_dear * fewestMoreRuns <= m_plan.secondsOfTiming;
        round -= m_repeatsDear ? 0.0 : m_dear;
        const auto start = Clock::now();
        for (int runs = 0; runs < mostRuns && !m_monitor.isStopped(); ++runs) {
            const double spent = std::chrono::duration<double>(Clock::now() - start).count();
            const bool isOver = spent + round > m_plan.secondsOfTiming;
            const bool isFarOver = spent + round > 2.0 * m_plan.secondsOfTiming;
            if (runs >= fewestMoreRuns && isOver && (runs >= m_plan.leastRuns || isFarOver))
                break;
            oneRound(runs, std::max(spent / m_plan.secondsOfTiming, double(runs) / mostRuns));
        }
        if (!m_monitor.isStopped())
            m_found.noise = noiseOf(m_all);
    }

private:
    double shareOf(std::size_t i) const { return static_cast<double>(i) / static_cast<double>(m_all.size()); }

    /// Decides what a sample of `one` is. Long runs of fixed steps, which cost the same all along, are cut; those
    /// of adaptive ones, which do not, are not. Returns the seconds that a sample takes.
    double size(Sampled &one, double share)
    {
        one.frames = one.run.frames();
        const double first = 1e-9 * one.row->firstRun * static_cast<double>(one.frames);
        if (one.row->setup.step.isAdaptive() && first > dearRun) {
            one.isDear = true;
            one.samples.push_back(one.row->firstRun);
            note(one);
            m_dear += first;
            return first;
        }
        double whole = one.run.seconds(one.frames, m_monitor, share);
        if (whole < shortestSample) // the first run found nothing in the caches
            whole = std::max(1e-9, one.run.seconds(one.frames, m_monitor, share));
        const double most = std::min(
            longestSample, m_plan.secondsOfTiming / (m_plan.leastRuns * static_cast<double>(m_all.size())));
        double expected = whole;
        if (whole > most && !one.row->setup.step.isAdaptive()) {
            const int framesPerOutput = one.row->setup.step.framesPerOutput;
            const auto rows = static_cast<std::int64_t>(static_cast<double>(one.frames) * most / whole);
            one.frames = std::max<std::int64_t>(1, rows / framesPerOutput) * framesPerOutput;
            expected = whole * static_cast<double>(one.frames) / static_cast<double>(one.run.frames());
        }
        one.repeats = static_cast<int>(std::ceil(std::max(1.0, shortestSample / expected)));
        if (whole > longestSample && !m_monitor.isStopped()) { // as good as any, and dear
            one.samples.push_back(1e9 * whole / static_cast<double>(one.run.frames()));
            note(one);
        }
        return expected * one.repeats;
    }

    /// One sample of each row. Each round begins at another row, and every second one goes the other way, so that no
    /// row always follows the same one.
    void oneRound(int round, double share)
    {
        const std::size_t count = m_all.size();
        const double told = 0.1 + 0.9 * std::min(1.0, share);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t step = round % 2 == 0 ? i : count - 1 - i;
            Sampled &one = m_all[(step + static_cast<std::size_t>(round) * 7) % count];
            if (one.isDear && !m_repeatsDear)
                continue;
            const double ns = one.sample(m_monitor, told);
            if (m_monitor.isStopped())
                return;
            one.samples.push_back(ns);
            note(one);
        }
        markFront(m_found.rows);
    }

    const StudyPlan &m_plan;
    Accuracy &m_found;
    StudyMonitor &m_monitor;
    std::vector<Sampled> m_all;
    double m_dear = 0.0;        ///< s: one run of all that are dear
    bool m_repeatsDear = false; ///< whether there is time to run those more often
};

}

void measureTimes(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor)
{
    Timing(script, plan, found, monitor).measure();
}

}
