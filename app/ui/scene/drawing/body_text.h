#pragma once

#include "sim/scene/state.h"

#include <QString>

namespace app {

/// Returns a body's position and speed as a sentence for screen readers: "foot 0 at (310, 240), moving 2.3 px a
/// frame".
QString bodySentence(const QString &name, sim::Vec2 at, sim::Vec2 speed);
/// Returns a magnitude with two decimals, or four significant digits from 1000 up; "< 0.01" for a tiny value.
QString shownMagnitude(double value);

}
