#pragma once

#include "sim/run/track.h"

#include <optional>

namespace app {

/// A detector that looks ahead in a run for visible motion without further input. A run looks still long before it
/// sleeps (see sim::Sleep): fading velocities no longer move anything visibly.
class RestDetector
{
public:
    /// Returns whether `run` shows nothing new after its cursor, however long it continues. Computes the run ahead
    /// until it sleeps, for some milliseconds per call. Nothing may move farther than 1e-6 px (degrees) from its
    /// place. Returns false until the answer is known.
    bool isOver(const sim::Track &run);
    /// Starts again after a change of the run.
    void forget() { *this = {}; }

private:
    void begin(const sim::Track &run);

    sim::State m_last;                 ///< at the previous call
    std::optional<sim::Track> m_ahead; ///< the run, computed ahead
    bool m_isOver = false;
    std::int64_t m_again = 0; ///< the frame from which a new attempt may be useful
};

}
