#pragma once

#include "app/listing/rule_program.h"
#include "sim/forward.h"
#include "sim/run/track.h"

#include <QString>

#include <optional>

namespace app {

/// Returns the mistake in the rule of a sandbox scene that ended the run. Empty if the run has not ended, or for another
/// reason. Computes the frame that failed once more.
std::optional<listing::RuleError> ruleErrorOf(const sim::Track &track);

/// Returns a mistake with its line and its bodies: "Line 4 of your rule, for p1: This divides by 0."
QString ruleMistakeSentence(const listing::RuleError &error, const sim::Scene &scene);

}
