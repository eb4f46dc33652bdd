#pragma once

#include "sim/pipeline/pipeline.h"

#include <functional>
#include <vector>

namespace sim {

/// Seconds, from any start on.
using Clock = std::function<double()>;

/// Two clocks: one that is read quickly, for what is short; and one for what is so long that other programs come in
/// between, which counts none of their time and may take longer to read.
struct TimerKind
{
    Clock wall;
    Clock threadCpu;
};

/// What each phase of a pipeline took, in seconds a lane and row.
struct PhaseTimes
{
    std::vector<double> run;     ///< all of it
    std::vector<double> prelude; ///< of that what is the method's own
};

/// The frames that are measured: some runs side by side, each a row further on than the one before, over the same
/// number of rows. Side by side, so that one reading of the clock times many calls of a phase, each on a state of its
/// own that the phase really meets: no call is repeated on what the one before has left. Few enough to stay in the
/// fastest cache where a single run would.
class TimingBatch
{
public:
    /// The rows after `from`. Nothing is computed before choose() is.
    TimingBatch(State from, TimerKind clocks);

    /// Chooses how many lanes and rows make a good sample. Returns false when `goesOn` said no.
    bool choose(const Pipeline &pipeline, const ShouldContinue &shouldContinue);
    /// Runs whole frames. Seconds a lane and row; empty when `goesOn` said no.
    std::optional<double> timeFrames(const Pipeline &pipeline, const ShouldContinue &shouldContinue);
    /// Runs all lanes through one phase, then through the next. Where a frame is so short that the processor is busy with
    /// most of it at once, a phase looks cheaper so than it is: there what `run` took is what the phase adds to the
    /// frame up to it.
    std::optional<PhaseTimes> timePhases(const Pipeline &pipeline, const ShouldContinue &shouldContinue);

    /// How many rows are run in a sample, in all lanes together.
    int rowsRun() const { return m_rows * static_cast<int>(m_starts.size()); }
    /// Seconds since the clock began.
    double now() const { return m_clock(); }
    /// Seconds that reading the clock adds to what is between two readings.
    double reading() const { return m_reading; }

private:
    void restore() { m_lanes = m_starts; }
    void read(const Clock &clock);
    /// Seconds that `work` takes on all lanes.
    template <class Work>
    double timed(Work &&work);
    std::optional<PhaseTimes> timeApart(const Pipeline &pipeline, const ShouldContinue &shouldContinue);
    /// The frame up to the phase numbered `last`, seconds a lane and row.
    std::optional<double> timeUpTo(std::size_t last, const Pipeline &pipeline,
                                   const ShouldContinue &shouldContinue);

    TimerKind m_clocks;
    Clock m_clock; ///< the one in use
    double m_reading = 0.0;
    bool m_isShort = false;
    std::vector<State> m_starts;
    std::vector<State> m_lanes;
    int m_rows = 1;
};

}
