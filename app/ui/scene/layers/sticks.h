#pragma once

#include "app/ui/scene/drawing/canvas.h"

namespace app {

/// Returns the strain of a stick: its length error as a fraction of its intended length. 0.01 is 1 % too
/// long. Returns 0 if the intended length is not positive.
double stickStrain(const lessons::StickView &stick, const sim::State &state);
/// Returns the colour of a stick: neutral up to a strain of 1 %, then from `near` to `past` at 20 %.
QColor stickColor(const Tokens &tokens, double strain);
/// Returns the factor for a stick's width, which shows the strain without colour. Stretched sticks get
/// thinner and compressed ones thicker, like a rubber band.
double stickSwelling(double strain);

}
