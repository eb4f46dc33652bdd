#pragma once

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/run/track.h"

#include <optional>

namespace sim {

/// The deviation of a stick from its length.
struct StickFit
{
    double error = 0.0;  ///< px, above 0 if the stick is too long
    double length = 0.0; ///< px, required length
    int a = -1;          ///< end points; -1: there is no stick
    int b = -1;
};

/// Returns the stick of `scene` with the largest error in `state`, of the sticks with a dynamic end.
StickFit worstStick(const Scene &scene, const State &state);

/// The number of frames before the given one over which stick errors are measured: one second.
constexpr std::int64_t fitFrames = 60;
/// px, stick errors up to this are invisible.
constexpr double fitting = 0.5;

/// The stick errors of a run, and remedies for them.
struct StickAdvice
{
    StickFit now; ///< the worst stick of the last fitFrames frames
    /// For each kind the smallest change that reduces the error to `fitting`. If none does, the change with
    /// the smallest error, if that is at most half of the present one. Empty if the sticks fit.
    std::vector<Remedy> remedies;
};

/// Runs `script` from its start to `frame` and measures its sticks. If they do not fit, tries shorter steps
/// and more iterations over the sticks. Returns nothing if there are no sticks, a trial would take too long,
/// the run does not reach the frame, or `shouldContinue` returns false.
/// @param iterations the parameter for the iterations; null if the scene has none
std::optional<StickAdvice> stickAdvice(const Script &script, std::int64_t frame,
                                       const IterationRange *iterations,
                                       const ShouldContinue &shouldContinue);

}
