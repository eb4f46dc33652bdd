#pragma once

#include "app/ui/scene/canvas.h"

namespace app {

/// Returns the strain of a stick: its error as a share of the length that it should have. 0.01 is 1 % too long. 0 where
/// that length is not above 0.
double stickStrain(const lessons::StickView &stick, const sim::State &state);
/// The colour of sticks up to a strain of 1 %, then over `near` to `past` at 20 %.
QColor stickColor(const Tokens &tokens, double strain);
/// What a stick's width is multiplied with: a second sign besides the colour. What is pulled long gets thinner,
/// what is pushed together thicker, as a rubber band does.
double stickSwelling(double strain);

}
