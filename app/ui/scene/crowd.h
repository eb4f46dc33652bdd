#pragma once

#include "app/ui/scene/figure.h"
#include "app/ui/scene/stencil.h"

/// How scenes of many small creatures are drawn: see Shown::isCrowd().
namespace app {

/// Empties `stencil`, for what `canvas` is to paint.
void begin(Stencil &stencil, const Canvas &canvas);
/// All straight legs that are long enough to be seen, `width` px of the screen wide.
void addLegs(Stencil &stencil, const Canvas &canvas, const Figure &figure, double width);
/// All discs that are smaller than `largest` px of the screen and large enough to be seen. A body is never lost.
void addDiscs(Stencil &stencil, const Canvas &canvas, const Figure &figure, double largest);
/// How wide a leg is on the screen.
double legWidthInCrowd(double zoom);

}
