#pragma once

#include "app/ui/theme/theme.h"
#include "sim/pipeline/method.h"

#include <QPainterPath>

namespace app {

/// The colour and marker of a method in plots. Methods of one family have similar colours.
struct MethodColors
{
    QColor color;
    int shape = 0; ///< for markerPath()
};

MethodColors inkOf(const sim::Method &method, const Theme &theme);

/// Returns a marker of about `size` px round (0, 0). Only every markerShapes-th method has the same shape.
QPainterPath markerPath(int shape, double size);
constexpr int markerShapes = 12;

}
