#pragma once

#include "sim/track.h"

#include <string>
#include <vector>

namespace sim {

/// What might mend a run that stopped by itself.
enum class RemedyKind { smallerStep, largerTolerance, otherMethod, moreDamping };

/// A run that was mended from its start on. All else, and all that a learner did, is as it was.
struct Remedy
{
    RemedyKind kind = RemedyKind::smallerStep;
    Script script;
    /// How many frames of it were tried, and held; 0 where trying it would have taken too long.
    std::int64_t heldFor = 0;
};

/// The parameter that says which share of its speed everything keeps each frame: less of it is more damping.
struct KeptShare
{
    std::string id; ///< empty where a scene has none
    double least = 0.0;
};

/// Looks for what mends `script`, which stopped at `stop`: of each kind the mildest that holds in a trial well beyond
/// that frame, and none of a kind that does not. The method without a limit to its step is the one of highest order that
/// fits. Leaves off, with what it has, when `goesOn` says no.
/// @throws nothing: what does not compose is no remedy
std::vector<Remedy> remediesFor(const Script &script, const Stop &stop, const KeptShare &damping,
                                const GoesOn &goesOn);

}
