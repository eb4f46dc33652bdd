#pragma once

#include "app/ui/scene/canvas.h"

namespace app {

/// Wind from `middle` (px of the screen), all round: curved streaks that drift away from it and fade. Where they
/// are depends on the frame alone, so they stand still when time does; with less movement they always do.
void drawWind(const Canvas &canvas, QPointF middle);

}
