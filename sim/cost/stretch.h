#pragma once

#include "sim/pipeline.h"

#include <functional>
#include <vector>

namespace sim {

/// Seconds, from any start on.
using Clock = std::function<double()>;

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
class Stretch
{
public:
    /// The rows after `from`. Nothing is computed before choose() is.
    Stretch(State from, Clock clock);

    /// Chooses how many lanes and rows make a good sample. Returns false when `goesOn` said no.
    bool choose(const Pipeline &pipeline, const GoesOn &goesOn);
    /// Runs whole frames. Seconds a lane and row; empty when `goesOn` said no.
    std::optional<double> timeFrames(const Pipeline &pipeline, const GoesOn &goesOn);
    /// Runs all lanes through one phase, then through the next.
    std::optional<PhaseTimes> timePhases(const Pipeline &pipeline, const GoesOn &goesOn);

    /// How many rows are run in a sample, in all lanes together.
    int rowsRun() const { return m_rows * static_cast<int>(m_starts.size()); }
    /// Seconds since the clock began.
    double now() const { return m_clock(); }
    /// Seconds that reading the clock adds to what is between two readings.
    double reading() const { return m_reading; }

private:
    void restore() { m_lanes = m_starts; }

    Clock m_clock;
    double m_reading = 0.0;
    std::vector<State> m_starts;
    std::vector<State> m_lanes;
    int m_rows = 1;
};

}
