#pragma once

#include "sim/catalogue/claims.h"

#include <functional>

namespace sim {

/// What came out when a case was run under a method.
struct Verdict
{
    Claim claim;
    bool holds = false;
    std::optional<Error> why; ///< what failed first, an id and values; empty if it holds
    std::int64_t frames = 0;  ///< that were computed, all of them finite
    double nsPerFrame = 0.0;  ///< measured, of computing alone; 0 when no frame was computed
    bool isComplete = true;   ///< false: nobody wanted the rest of it
    /// Whether it breaks what the method undertook.
    bool isBroken() const { return isComplete && claim.isMade && !holds; }
};

/// What is wrong with a moment of a run of `hard`, after `frame` frames: a point is too far, the middle has moved, a
/// stick is too wrong. Empty if nothing is. `first`: the scene at frame 0.
std::optional<Error> findViolation(const HardCase &hard, const Scene &first, const Scene &scene,
                                   const State &state, std::int64_t frame);
/// What is wrong with the end of its run, `rowFrames` after `before`; empty if nothing is, and where no rest is told.
std::optional<Error> findRestViolation(const HardCase &hard, const Scene &scene, const State &before,
                                       const State &state, int framesPerOutput);

/// Told now and then how much of it is done, 0 to 1. Returns whether to go on.
using JudgeProgress = std::function<bool(double)>;

/// Runs `hard` under `method`, twice: every frame must be finite, bounded and with no stick too wrong, the end at
/// rest where there is a right rest, and the second run the same in every bit.
Verdict judge(const HardCase &hard, const MethodPtr &method, const RunSize &size,
              const JudgeProgress &progress = {});

}
