#pragma once

#include "sim/run/timeline.h"

#include <QString>

namespace app {

/// Inside a frame, what has been done of it and what has not, in words; empty between two frames.
QString frameCaption(const sim::Timeline &timeline);

}
