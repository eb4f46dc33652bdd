#pragma once

#include "sim/base/error.h"

#include <QString>

namespace app {

/// Why a method claims no hard case, or what failed in one; empty for any other error.
QString hardSentence(const sim::Error &error);

}
