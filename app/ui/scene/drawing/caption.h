#pragma once

#include "sim/run/timeline.h"

#include <QString>

namespace app {

/// Returns a sentence about what the phases have done so far inside a frame, and what is still to come. Empty between
/// two frames.
QString frameCaption(const sim::Timeline &timeline);

}
