#pragma once

#include "sim/run/track.h"

#include <optional>

namespace app {

/// Looks ahead in a run: whether there will be anything to see in it if nobody touches it. Long before a run sleeps
/// (see sim::Sleep) it stands still for the eye: velocities that fade do not move anything any more.
class Foresight
{
public:
    /// Whether `run` shows nothing new from its cursor on, however long it goes on: it is computed ahead, for some
    /// milliseconds a call, until it sleeps, and nothing must come farther than 1e-6 px (degrees) from where it is.
    /// False as long as that is not known.
    bool isOver(const sim::Track &run);
    /// The run has changed.
    void forget() { *this = {}; }

private:
    void begin(const sim::Track &run);

    sim::State m_last;                 ///< at the call before
    std::optional<sim::Track> m_ahead; ///< on its way
    bool m_isOver = false;
    std::int64_t m_again = 0; ///< the frame from which another look may be worth it
};

}
