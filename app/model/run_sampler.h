#pragma once

#include "app/model/quantity.h"
#include "app/model/samples.h"
#include "sim/run/track.h"

namespace app {

/// Reads quantities off the rows of a run, one row after the other. It reads what is kept of the run, computes again
/// what is not, and changes nothing in it.
class RunSampler
{
public:
    RunSampler() = default;
    /// `quantities` must name their bodies. See Samples for the other two.
    RunSampler(std::vector<Quantity> quantities, std::int64_t first, int framesPerOutput,
               std::int64_t stride);

    const Samples &samples() const { return m_samples; }
    /// Takes the next row of `track`, which was computed before: into the samples, or on the way to their first.
    void takeRow(const sim::Track &track);
    /// Forgets what is after `frame`, where the run is another one now.
    void forgetAfter(std::int64_t frame);
    /// Forgets what is before `frame`.
    void forgetBefore(std::int64_t frame) { m_samples.forgetBefore(frame); }
    void thin() { m_samples.thin(); }

private:
    void read(const sim::Track &track, const sim::State *before);

    std::vector<Quantity> m_quantities;
    Samples m_samples;
    QuantityReader m_reader;
    int m_framesPerOutput = 1;
    bool m_comparesRows = false;     ///< whether one of them takes the row before
    std::optional<sim::State> m_end; ///< at the end of the row that was taken last
};

/// The state of `track` one row after `end`, the state at the end of an earlier row; that row was computed before.
sim::State stateAfter(sim::State end, const sim::Track &track);

}
