#pragma once

#include "app/ui/scene/drawing/canvas.h"

namespace app {

/// Draws wind from `middle` (screen px) in all directions: curved streaks that move outwards and fade. Their
/// positions depend only on the frame, so they stop when time stops. With reduced motion they never move.
void drawWind(const Canvas &canvas, QPointF middle);

}
