#pragma once

#include "sim/base/step_size.h"

#include <QString>

namespace app {

/// A step as people read it: "1/4 frame", "2 frames".
QString stepTitle(double h);
/// A tolerance as people read it, in px: "0.05\u2009px", "10⁻⁸\u2009px".
QString toleranceTitle(double tolerance);
/// The step or the tolerance, whichever it is.
QString stepTitle(const sim::StepSize &step);

/// The step that a text means: "1/4", "0.25" or "2", with or without a unit; 0 if none. A tolerance likewise:
/// "0.05", "1e-6".
double stepFromText(const QString &text);

}
