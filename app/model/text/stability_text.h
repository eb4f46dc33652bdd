#pragma once

#include "app/model/analysis/stability_monitor.h"

#include <QString>

namespace app {

// Texts of the stability gauge.

/// How near a step is to the stability limit.
enum class Nearness { none, far, near, past };
Nearness nearnessOf(const sim::Stability &stability);

/// Returns the text beside the gauge: "72\u2009% of the limit", "no limit".
QString gaugeWords(const StabilityReading &reading);
/// Returns what limits the step here and which spring or body determines it. Key values are marked with <b>.
QString stabilityVerdict(const StabilityReading &reading);
/// Returns which active effects the analysis ignores. Empty if there are none.
QString leftOutWords(const StabilityReading &reading);

/// Returns how well sticks keep their lengths, with key values in <b>. Empty if there are no sticks or nothing is
/// known.
QString stickVerdict(const StabilityReading &reading);

/// Returns the title of a remedy: "Use a step of 1/2\u2009frame".
QString remedyTitle(const sim::Remedy &remedy);
/// Returns the title for a button: & precedes the shortcut letter.
QString remedyLabel(const sim::Remedy &remedy);
/// Returns the effect of a remedy: "then at 40\u2009% of the limit".
QString remedyOutcome(const sim::Remedy &remedy);

/// Returns a growth factor per frame in words: "grow by 3.9\u2009% a frame".
QString growthWords(double growth);

}
