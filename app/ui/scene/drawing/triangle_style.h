#pragma once

#include "app/ui/scene/drawing/canvas.h"

namespace app {

// The sides of the right triangle of an angle differ in their lines, the same in the scene and on the unit circle.

constexpr double triangleSide = 3.0; ///< screen px, width of the side beside the angle and the opposite one
constexpr double triangleLongSide = 1.2; ///< screen px

inline QPen besidePen(const QColor &ink)
{
    return QPen(ink, triangleSide, Qt::SolidLine, Qt::FlatCap);
}

inline QPen oppositePen(const QColor &ink)
{
    return dashed(ink, triangleSide, {4.0, 3.0});
}

}
