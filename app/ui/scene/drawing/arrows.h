#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <vector>

namespace app {

/// The line style of an arrow. Kinds of arrow differ in more than colour.
struct ArrowStyle
{
    enum class Line { plain, dashes, dots, twofold, capped, dashDots };
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

/// Draws an arrow; does nothing for arrows shorter than 3 px.
void drawArrow(QPainter &painter, const Arrow &arrow, const QColor &ground);

/// Returns the force arrows of every point, from the edges of the bodies, and the sum on the selected body.
std::vector<Arrow> pullArrows(const SceneContent &shown, const Camera &camera, const Theme &theme);
/// Returns the velocity arrows, from the edges of the bodies. Inside a frame, each velocity that the last phase
/// changed also gets an arrow of its earlier value. That arrow is fainter and comes before the present one.
std::vector<Arrow> velocityArrows(const SceneContent &shown, const Camera &camera, const Theme &theme);

}
