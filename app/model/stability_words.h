#pragma once

#include "app/model/stability_watch.h"

#include <QString>
#include <QStringList>

namespace app {

// What the stability gauge says, in words.

/// How near the limit a step is.
enum class Nearness { none, far, near, past };
Nearness nearnessOf(const sim::Stability &stability);

/// "72\u2009% of the limit", "no limit": what stands beside the gauge.
QString gaugeWords(const StabilityReading &reading);
/// What bounds the step here and which spring or body decides it, with <b> round what matters.
QString stabilityVerdict(const StabilityReading &reading);
/// What acts here and is no part of it; empty where there is nothing.
QString leftOutWords(const StabilityReading &reading);

/// How well sticks fit, with <b> round what matters; empty where there are none, or nobody knows.
QString stickVerdict(const StabilityReading &reading);

/// "Use a step of 1/2\u2009frame".
QString remedyTitle(const sim::Remedy &remedy);
/// The same for a button: the letter after & is its key.
QString remedyLabel(const sim::Remedy &remedy);
/// "then at 40\u2009% of the limit".
QString remedyOutcome(const sim::Remedy &remedy);

/// "grow by 3.9\u2009% a frame".
QString growthWords(double growth);

}
