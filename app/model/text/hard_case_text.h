#pragma once

#include "sim/base/error.h"

#include <QString>

namespace app {

/// Returns why a method does not claim a hard case, or what failed in one. Empty for any other error.
QString hardSentence(const sim::Error &error);

}
