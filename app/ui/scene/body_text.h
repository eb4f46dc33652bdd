#pragma once

#include "sim/scene/state.h"

#include <QString>

namespace app {

/// Where a body is and how fast, for those who do not see it: "foot 0 at (310, 240), moving 2.3 px a frame".
QString bodySentence(const QString &name, sim::Vec2 at, sim::Vec2 speed);
/// A magnitude in at most three places, "0.00" for nothing and "< 0.01" for almost nothing.
QString shownMagnitude(double value);

}
