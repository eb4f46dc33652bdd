#pragma once

#include "sim/base/step_size.h"

#include <QString>

namespace app {

/// Returns a step for the screen: "1/4 frame", "2 frames".
QString stepTitle(double h);
/// Returns a tolerance in px for the screen: "0.05\u2009px", "10⁻⁸\u2009px".
QString toleranceTitle(double tolerance);
/// Returns the step, or the tolerance if `step` is adaptive.
QString stepTitle(const sim::StepSize &step);

/// Returns the step that `text` gives, or 0 if it gives none: "1/4", "0.25" or "2", with or without a unit. Reads a
/// tolerance in the same way: "0.05", "1e-6".
double stepFromText(const QString &text);

}
