#pragma once

#include "sim/run/script/script.h"

namespace app {

// Comparison of scripts, to tell whether a cached run is still up to date.

/// Returns whether two methods compute the same steps: they have the same id, and the same text if it is a listing.
bool sameMethod(const sim::MethodPtr &a, const sim::MethodPtr &b);

/// Returns `script` without its input and without the functions that build its scene.
sim::Script withoutInput(const sim::Script &script);

/// Returns whether two scripts of the same step make the same run, apart from their input.
bool sameRun(const sim::Script &a, const sim::Script &b);

/// Returns whether two scripts of the same step have the same values, starts of bodies and effects.
bool sameButForInput(const sim::Script &a, const sim::Script &b);

/// Returns whether the scenes of two scripts have the same rule, or none.
bool sameRule(const sim::Script &a, const sim::Script &b);

/// Returns whether two scripts of the same step make the same run, including their input.
bool sameScript(const sim::Script &a, const sim::Script &b);

}
