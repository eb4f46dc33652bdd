#pragma once

#include "sim/forward.h"

#include <cstdint>
#include <list>

namespace lessons {

/// An accurate reference run of a script: the same scene and input, computed by the method of the highest
/// order with a tight tolerance. Caches the last runs it was asked for, which changes only how long an answer
/// takes.
class ExactRun
{
public:
    ExactRun();
    ~ExactRun();

    /// Largest frame that is computed. After it the reference run's own error might matter.
    static constexpr std::int64_t maxFrames = 1200;
    static constexpr double tolerance = 1e-11; ///< px per step
    /// A run that needs more force evaluations ends there, because the window waits for it.
    static constexpr std::int64_t maxEvaluations = 400'000;

    /// Returns the state after `frame` frames. Null after maxFrames, after the end of a run that stopped
    /// early, and for a scene without a continuous limit. The pointer is valid until the next call.
    const sim::State *at(const sim::Script &script, std::int64_t frame);
    /// Returns the largest distance, in px, of any point of `state` from the reference state after `frame`
    /// frames. NaN if at() has none.
    double distance(const sim::Script &script, const sim::State &state, std::int64_t frame);

private:
    struct CachedRun;
    sim::Track *trackOf(const sim::Script &script);

    std::list<CachedRun> m_cache; ///< most recently used first
};

}
