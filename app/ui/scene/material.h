#pragma once

#include "app/ui/scene/canvas.h"

/// Light and shade: what gives the scene depth. High contrast has none of it.
namespace app {

/// Whether colours are drawn as they are, without light and shade.
inline bool isFlat(const Theme &theme)
{
    return theme.scheme() == Scheme::highContrast;
}

/// `share` of the way from one colour to the other.
QColor mixed(const QColor &from, const QColor &to, double share);

/// Returns what a disc is filled with: `color` in its middle, lighter on top, darker at its lower rim. Small discs are
/// of one colour.
QBrush roundBrush(const Canvas &canvas, QPointF centre, double radius, const QColor &color);

/// A soft dark spot, an ellipse that fades to nothing at its rim. `strength`: 0 to 1, in its middle.
void drawShade(QPainter &painter, QPointF centre, QSizeF half, double strength);

/// How strong a shadow in full is: on a dark background it has to be darker to be seen.
double fullShade(const Theme &theme);

}
