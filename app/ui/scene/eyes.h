#pragma once

#include "app/ui/scene/canvas.h"

namespace app {

/// The radius on the screen from which a body has eyes.
constexpr double smallestFace = 12.0;

/// Where two eyes are, and what they follow.
struct Face
{
    QPointF centre;
    double radius = 0.0;      ///< on the screen, of the disc that the eyes are meant for
    QPointF across{1.0, 0.0}; ///< from one eye to the other, of length 1
    QPointF up{0.0, 0.0};     ///< how far above the centre the eyes are, in radii
    sim::Vec2 velocity;       ///< px/frame: they look along it
};

/// Two dots that look along the velocity; none where a face is too small for them. The painter must have no pen.
void drawEyes(const Canvas &canvas, const Face &face);

}
