#pragma once

#include "sim/run/track.h"

#include <QString>

namespace app {

/// What a scene costs once it has come to rest, in one sentence: nothing, or why it goes on costing.
QString restSentence(const sim::Track &track);

}
