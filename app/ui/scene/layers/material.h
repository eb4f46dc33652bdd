#pragma once

#include "app/ui/scene/drawing/canvas.h"
#include "app/ui/theme/colors.h"

/// Light and shade, for an impression of depth. The high-contrast themes have neither.
namespace app {

/// Returns whether colours are drawn without light and shade.
inline bool isFlat(const Theme &theme)
{
    return theme.scheme() == Scheme::highContrast;
}

/// Returns the brush of a disc: `color` in the middle, lighter at the top, darker at the lower rim. Small
/// discs have one plain colour.
QBrush roundBrush(const Canvas &canvas, QPointF centre, double radius, const QColor &color);

/// Draws a soft dark ellipse that fades towards its rim. `strength`: 0 to 1, at the centre.
void drawShade(QPainter &painter, QPointF centre, QSizeF half, double strength);

/// Returns the strength of a full shadow: a dark background needs darker shadows.
double fullShade(const Theme &theme);

}
