#pragma once

#include "app/ui/scene/canvas.h"

namespace app {

/// By which part of its wanted length a stick is too long (or, negative, too short).
double stickError(const lessons::StickLook &stick, const sim::State &state);
/// The colour of sticks up to an error of 1 %, then over `near` to `past` at 20 %.
QColor stickColor(const Tokens &tokens, double error);
/// What a stick's width is multiplied with: a second sign besides the colour. What is pulled long gets thinner,
/// what is pushed together thicker, as a rubber band does.
double stickSwelling(double error);

}
