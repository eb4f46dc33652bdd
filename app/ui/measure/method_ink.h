#pragma once

#include "app/ui/theme/theme.h"
#include "sim/pipeline/method.h"

#include <QPainterPath>

namespace app {

/// How plots draw a method: each has a colour and a shape of its own, methods of one family related colours.
struct MethodInk
{
    QColor color;
    int shape = 0; ///< for markerPath()
};

MethodInk inkOf(const sim::Method &method, const Theme &theme);

/// A marker of about `size` px round (0, 0). Shapes that no two methods share, as far as there are shapes.
QPainterPath markerPath(int shape, double size);
constexpr int markerShapes = 12;

}
