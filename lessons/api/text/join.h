#pragma once

#include "lessons/api/parameter.h"
#include "lessons/api/text/document.h"
#include "lessons/api/try.h"

namespace lessons {

/// Returns the things to try of `document`, in its order, each with the check that has its id.
/// @throws DocumentError if a text has no check, a check no text, a condition no sentence, or a sentence no condition
std::vector<Try> joinedTries(const Document &document, const std::vector<Check> &checks);

/// Checks that `parameters`, those of the step, have each one that `document` declares.
/// @throws DocumentError if not
void checkParameters(const Document &document, const std::vector<Parameter> &parameters);

/// Checks that the tasks of `document` and their near misses are about gaps of `listing`.
/// @throws DocumentError if not
void checkGaps(const Document &document, const Listing &listing);

}
