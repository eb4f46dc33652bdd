#pragma once

#include "lessons/api/step.h"
#include "sim/run/track.h"

#include <memory>

namespace app {

/// A run beside a step's own run: the same script, computed by the companion's method. It follows changes of the
/// script, and recomputes only the changed part.
class CompanionRun
{
public:
    /// `companion` must outlive this object, and its method must exist.
    explicit CompanionRun(const lessons::Companion &companion) : m_companion(companion) {}

    /// Continues towards `frame` of the run of `script`, for at most some milliseconds. All scripts of one
    /// CompanionRun must build their scenes in the same way. Returns whether the run has reached `frame` or its
    /// end.
    bool follow(const sim::Script &script, std::int64_t frame);
    /// Returns the computed run, or null if the companion's method cannot compute the scene.
    const sim::Track *track() const { return m_track.get(); }

private:
    void take(const sim::Script &script);

    const lessons::Companion &m_companion;
    sim::Script m_script; ///< the last given script
    bool m_isTaken = false;
    std::unique_ptr<sim::Track> m_track;
};

}
