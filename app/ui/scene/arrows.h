#pragma once

#include "app/ui/scene/canvas.h"

#include <vector>

namespace app {

/// How an arrow is drawn. Kinds differ by more than their colour.
struct ArrowStyle
{
    enum class Line { plain, dashes, dots, twofold, capped };
    QColor color;
    double width = 3.0;
    Line line = Line::plain;
    bool openHead = false;
};

/// An arrow on the screen.
struct Arrow
{
    QPointF from;
    QPointF vector;
    ArrowStyle style;

    QRectF bounds() const;
};

ArrowStyle styleOf(sim::EffectKind kind, const Theme &theme);
ArrowStyle sumStyle(const Theme &theme);
ArrowStyle velocityStyle(const Theme &theme);

/// Arrows shorter than 3 px are not drawn.
void drawArrow(QPainter &painter, const Arrow &arrow, const QColor &ground);

/// What pulls at every point, from the edges of the bodies, and the sum on the selected one.
std::vector<Arrow> pullArrows(const Shown &shown, const Camera &camera, const Theme &theme);
/// The velocities, from the edges of the bodies. Inside a frame each that the last phase changed has an arrow of what it
/// was, too, fainter and before its own.
std::vector<Arrow> velocityArrows(const Shown &shown, const Camera &camera, const Theme &theme);

}
