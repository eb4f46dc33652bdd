#pragma once

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/run/track.h"

#include <optional>

namespace sim {

/// How far from its length a stick is.
struct StickFit
{
    double error = 0.0;  ///< px: too long when above 0
    double length = 0.0; ///< px, as it should be
    int a = -1;          ///< its ends; -1: there is none
    int b = -1;
};

/// The stick of `scene` that is farthest from its length in `state`, of those with an end that feels anything.
StickFit worstStick(const Scene &scene, const State &state);

/// How many frames up to the one that is asked about are looked at: a second.
constexpr std::int64_t fitFrames = 60;
/// The error that sticks may keep, in px: less is not seen.
constexpr double fitting = 0.5;

/// What sticks are like in a run, and what would make them fit better.
struct StickAdvice
{
    StickFit now; ///< the worst of the last fitFrames frames
    /// The mildest change of each kind that leaves no more than `fitting`, or, where none does, the one that leaves
    /// least, if that is no more than half. Remedy::stickError is what it leaves. None where sticks fit.
    std::vector<Remedy> remedies;
};

/// Runs `script` from its start to `frame` and looks at its sticks; where they do not fit, with shorter steps and with
/// more passes over the list of sticks, too. Empty where there are no sticks, where a trial would take too long, where the
/// run does not come to that frame, and when `goesOn` says no.
/// @param passes the parameter that counts passes; null where the scene has none
std::optional<StickAdvice> adviseOnSticks(const Script &script, std::int64_t frame,
                                          const IterationRange *passes, const ShouldContinue &shouldContinue);

}
