#pragma once

#include "lessons/api/step.h"
#include "sim/run/track.h"

#include <memory>

namespace app {

/// The run beside a step's own: the same script by the companion's method. What is changed in the script, it takes
/// over; what did not change is not computed again.
class CompanionRun
{
public:
    /// `companion` must outlive it, and its method must be there.
    explicit CompanionRun(const lessons::Companion &companion) : m_companion(companion) {}

    /// Goes on towards `frame` of the run of `script`, for some milliseconds at most. All scripts of one
    /// CompanionRun must build their scenes in the same way. Returns whether it has come as far as it can.
    bool follow(const sim::Script &script, std::int64_t frame);
    /// Null where the companion's method cannot compute the scene.
    const sim::Track *track() const { return m_track.get(); }

private:
    void take(const sim::Script &script);

    const lessons::Companion &m_companion;
    sim::Script m_script; ///< as last given
    bool m_isTaken = false;
    std::unique_ptr<sim::Track> m_track;
};

}
