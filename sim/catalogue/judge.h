#pragma once

#include "sim/catalogue/claims.h"

#include <functional>

namespace sim {

/// The result of running a case under a method.
struct Verdict
{
    Claim claim;
    bool holds = false;       ///< whether the method passed the case
    std::optional<Error> why; ///< the first failure; empty if it passed
    std::int64_t frames = 0;  ///< number of computed frames, all finite
    double nsPerFrame = 0.0;  ///< measured computing time per frame; 0 if no frame was computed
    bool isComplete = true;   ///< false if judging was cancelled
    /// Returns whether the method failed although it claims the case.
    bool isBroken() const { return isComplete && claim.isMade && !holds; }
};

/// Returns the first violation of the bounds of `hardCase` at `frame`: a point is too far away, the centre of
/// mass moved, or the length of a stick is wrong. Empty if there is none. `first`: the scene at frame 0.
std::optional<Error> findViolation(const HardCase &hardCase, const Scene &first, const Scene &scene,
                                   const State &state, std::int64_t frame);
/// Returns the first difference between the end of a run and the rest that `hardCase` requires. Empty if
/// there is no difference, or if no rest is required. `before`: the state `framesPerOutput` frames before the
/// end.
std::optional<Error> findRestViolation(const HardCase &hardCase, const Scene &scene, const State &before,
                                       const State &state, int framesPerOutput);

/// Receives the progress of judge() from time to time, 0 to 1. Returns false to cancel.
using JudgeProgress = std::function<bool(double)>;

/// Runs `hardCase` under `method` twice. The case passes if all output steps are finite and within the
/// bounds, the run ends at the required rest, and both runs give the same bits.
/// For Requirement::rejected and Requirement::overflows it passes if the run is rejected, or ends, as
/// required.
Verdict judge(const HardCase &hardCase, const MethodPtr &method, const RunSize &size,
              const JudgeProgress &progress = {});

}
