#pragma once

#include <QPointF>

class QColor;
class QPainter;
class QRect;

namespace app {

class Theme;

/// Paints the dot of a breakpoint. It is hollow while the breakpoint is off, and a condition gives it two bars, like an
/// equals sign.
void paintBreakpoint(QPainter &painter, QPointF centre, bool isOn, bool hasCondition, const Theme &theme);

/// Paints the arrow beside a line whose row begins at `top`.
void paintMarginArrow(QPainter &painter, int top, const QColor &color);

/// Paints the frame that marks a row in high contrast, where other themes have a background.
void paintLineFrame(QPainter &painter, const QRect &row, const Theme &theme);

}
