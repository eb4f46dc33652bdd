#pragma once

#include "app/ui/theme/theme.h"

#include <QPainter>

namespace app {

/// Solid for effects that act, hollow for others.
enum class MarkFill { solid, hollow };

/// Draws a small square in the colour of a kind of effects, with a sign, so that kinds differ without colour: gravity
/// points down, damping is dashed, a contact is hatched, a driver is a double line, wind is dotted, a stick has caps at
/// its ends, a spring is plain.
void drawKindMark(QPainter &painter, const QRectF &square, sim::EffectKind kind, MarkFill fill,
                  const Theme &theme);

}
