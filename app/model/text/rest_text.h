#pragma once

#include "sim/run/track.h"

#include <QString>

namespace app {

/// Returns one sentence on the cost of a scene at rest: nothing, or why it still costs time.
QString restSentence(const sim::Track &track);

}
