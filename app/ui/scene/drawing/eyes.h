#pragma once

#include "app/ui/scene/drawing/canvas.h"

namespace app {

/// The smallest radius at which a body gets eyes, screen px.
constexpr double smallestFace = 12.0;

/// The position of a pair of eyes, and the velocity that they follow.
struct Face
{
    QPointF centre;
    double radius = 0.0;      ///< of the disc that carries the eyes, screen px
    QPointF across{1.0, 0.0}; ///< unit vector from one eye to the other
    QPointF up{0.0, 0.0};     ///< how far above the centre the eyes are, in radii
    sim::Vec2 velocity;       ///< px/frame: the eyes look in this direction
};

/// Draws two eyes that look along the velocity, unless the face is too small for them. The painter must have no pen.
void drawEyes(const Canvas &canvas, const Face &face);

}
