#pragma once

#include "sim/run/script/script.h"

namespace app {

// What is kept of a run by those who watch it, to tell whether it is still the same.

/// `script` without its input and without what builds its scene.
sim::Script withoutInput(const sim::Script &script);

/// Whether two scripts of the same step make the same run, as far as no input differs.
bool sameRun(const sim::Script &a, const sim::Script &b);

/// Whether they make the same run with their input, too.
bool sameScript(const sim::Script &a, const sim::Script &b);

}
