#pragma once

#include "app/model/series/quantity.h"
#include "app/model/series/samples.h"
#include "sim/run/track.h"

namespace app {

/// Reads quantities from the output steps of a run, one after the other. It uses the states that the run has kept and
/// computes the others again. It does not change the run.
class RunSampler
{
public:
    RunSampler() = default;
    /// `quantities` must name their bodies. See Samples for `first` and `stride`.
    RunSampler(std::vector<Quantity> quantities, std::int64_t first, int framesPerOutput,
               std::int64_t stride);

    const Samples &samples() const { return m_samples; }
    /// Reads the next output step of `track`, which must have been computed before. Steps before the first sample are
    /// only passed through.
    void readNext(const sim::Track &track);
    /// Drops the samples after `frame`, where the run has changed.
    void forgetAfter(std::int64_t frame);
    /// Drops the samples before `frame`.
    void forgetBefore(std::int64_t frame) { m_samples.forgetBefore(frame); }
    void thin() { m_samples.thin(); }

private:
    void read(const sim::Track &track, const sim::State *before);

    std::vector<Quantity> m_quantities;
    Samples m_samples;
    QuantityReader m_reader;
    int m_framesPerOutput = 1;
    bool m_needsPreviousStep = false; ///< whether a quantity also needs the previous output step
    std::optional<sim::State> m_end;  ///< at the end of the last output step that was read
};

/// Returns the state of `track` one output step after `end`, the state at the end of an earlier output step. That
/// output step must have been computed before.
sim::State stateAfter(sim::State end, const sim::Track &track);

}
