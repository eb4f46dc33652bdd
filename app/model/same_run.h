#pragma once

#include "sim/script.h"

namespace app {

// What is kept of a run by those who watch it, to tell whether it is still the same.

/// `script` without its input and without what builds its scene.
sim::Script withoutInput(const sim::Script &script);

/// Whether two scripts of the same step make the same run, as far as no input differs.
bool sameRun(const sim::Script &a, const sim::Script &b);

/// The frame of the first event in which two inputs differ: rows that end before it are the same. The largest number
/// where they do not.
std::int64_t firstDifference(const std::vector<sim::Event> &a, const std::vector<sim::Event> &b);

}
