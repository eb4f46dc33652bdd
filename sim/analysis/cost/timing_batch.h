#pragma once

#include "sim/pipeline/pipeline.h"

#include <functional>
#include <vector>

namespace sim {

/// Returns seconds since an arbitrary start.
using Clock = std::function<double()>;

/// Two clocks. The wall clock is quick to read and used for short measurements. The CPU clock of the thread
/// does not count other programs, but may be slower to read.
struct Clocks
{
    Clock wall;
    Clock threadCpu;
};

/// The time of each phase of a pipeline, in seconds per lane and output step.
struct PhaseTimes
{
    std::vector<double> run;     ///< whole phase
    std::vector<double> prelude; ///< the part of the phase that is the method's own work
};

/// The frames that are measured: several copies of a run (lanes), each one output step ahead of the one
/// before, over the same number of output steps. One reading of the clock therefore times many calls of a
/// phase. Each call works on a state that really occurs in the run, never on the result of the previous call.
/// There are few enough lanes to fit the fastest cache, if a single run does. The output steps of an adaptive method
/// contain whole steps, which can be several frames long.
class TimingBatch
{
public:
    /// Measures the output steps after `from`. Call choose() first.
    TimingBatch(State from, Clocks clocks);

    /// Chooses how many lanes and output steps make a good sample. Returns false when `shouldContinue`
    /// returned false.
    bool choose(const Pipeline &pipeline, const ShouldContinue &shouldContinue);
    /// Runs whole output steps. Returns seconds per lane and output step, or nothing when `shouldContinue`
    /// returned false.
    std::optional<double> timeFrames(const Pipeline &pipeline, const ShouldContinue &shouldContinue);
    /// Runs all lanes through one phase, then through the next. A processor overlaps the phases of very short
    /// steps, so timing them one by one underestimates their cost. For such steps `run` is the time that the
    /// phase adds to the step up to it.
    std::optional<PhaseTimes> timePhases(const Pipeline &pipeline, const ShouldContinue &shouldContinue);

    /// Returns the number of output steps in a sample, over all lanes.
    int outputStepsRun() const { return m_outputSteps * static_cast<int>(m_starts.size()); }
    /// Returns the seconds on the clock in use.
    double now() const { return m_clock(); }
    /// Returns the seconds that reading the clock adds to a measurement.
    double reading() const { return m_reading; }

private:
    void restore() { m_lanes = m_starts; }
    void useClock(const Clock &clock);
    /// Returns the seconds that `work` takes on all lanes, per lane and output step.
    template <class Work>
    double timed(Work &&work);
    std::optional<PhaseTimes> timeEachPhase(const Pipeline &pipeline, const ShouldContinue &shouldContinue);
    /// Returns the time of the step up to and including phase `last`, in seconds per lane and output step.
    std::optional<double> timeThroughPhase(std::size_t last, const Pipeline &pipeline,
                                           const ShouldContinue &shouldContinue);

    Clocks m_clocks;
    Clock m_clock; ///< the clock in use
    double m_reading = 0.0;
    bool m_isShort = false;      ///< whether the processor overlaps the phases of a step
    std::vector<State> m_starts; ///< of the lanes
    std::vector<State> m_lanes;
    int m_outputSteps = 1;
};

}
