#pragma once

#include "sim/forward.h"

#include <cstdint>
#include <list>

namespace lessons {

/// The run of a script without the error of its method, or with as little of it as numbers allow: the same scene
/// and input, computed by the method of the highest order with a tight tolerance. Keeps the runs that it was last
/// asked about: that changes how long an answer takes, and nothing else.
class ExactRun
{
public:
    ExactRun();
    ~ExactRun();

    /// Frames that are computed; beyond, errors of the exact run itself might count.
    static constexpr std::int64_t maxFrames = 1200;
    static constexpr double tolerance = 1e-11; ///< px a step
    /// A run that takes more computations of all forces is left off there: the window would have to wait for it.
    static constexpr std::int64_t maxEvaluations = 400'000;

    /// The state after `frame` frames; null past `longest`, where the scene has no such run, and where that was left
    /// off. It is good until the next call.
    const sim::State *at(const sim::Script &script, std::int64_t frame);
    /// The largest distance of any point of `state`, at that frame, from there, in px; NaN where there is none.
    double distance(const sim::Script &script, const sim::State &state, std::int64_t frame);

private:
    struct CachedRun;
    sim::Track *trackOf(const sim::Script &script);

    std::list<CachedRun> m_kept; ///< the one asked for last comes first
};

}
