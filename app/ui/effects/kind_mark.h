#pragma once

#include "app/ui/theme/theme.h"

#include <QPainter>

namespace app {

/// Whether what a mark stands for is there.
enum class MarkFill { solid, hollow };

/// A small square in the colour of a kind of effects, with the kind's second sign in it: gravity points down, damping is
/// dashed, a contact is hatched, a driver is a double line, wind is dotted, a stick has caps at its ends, a spring is
/// plain.
void drawKindMark(QPainter &painter, const QRectF &square, sim::EffectKind kind, MarkFill fill,
                  const Theme &theme);

}
