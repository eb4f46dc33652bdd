#pragma once

#include "app/ui/scene/drawing/figure.h"
#include "app/ui/scene/layers/stencil.h"

/// Painting of scenes with many small creatures: see SceneContent::isCrowd().
namespace app {

/// Clears `stencil` and sets it up for the area of `canvas`.
void begin(Stencil &stencil, const Canvas &canvas);
/// Adds all straight legs that are long enough to be visible, `width` screen px wide.
void addLegs(Stencil &stencil, const Canvas &canvas, const Figure &figure, double width);
/// Adds all discs smaller than `largest` screen px and large enough to be visible. Bodies are always added.
void addDiscs(Stencil &stencil, const Canvas &canvas, const Figure &figure, double largest);
/// Returns the width of a leg, screen px.
double legWidthInCrowd(double zoom);

}
