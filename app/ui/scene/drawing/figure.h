#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <QPainterPath>

namespace app {

/// A state of a run, and the lesson view that draws it. Both must outlive this object.
struct Figure
{
    const lessons::View &view;
    const sim::State &state;
};

/// Returns the far end of a spring that begins at point `a`.
sim::Vec2 endOf(const lessons::SpringView &spring, const sim::State &state);
/// Returns the visible straight legs.
QList<QLineF> straightLegs(const Canvas &canvas, const Figure &figure);
/// Returns the visible curved legs. Each is a quadratic curve from the foot to the body, with the control point above
/// the foot.
QPainterPath curvedLegs(const Canvas &canvas, const Figure &figure);
/// Returns the smooth closed curve through the points of a skin (Catmull and Rom, "A class of local interpolating
/// splines", 1974, as cubics).
QPainterPath skinPath(const Canvas &canvas, const sim::State &state, const lessons::SkinView &skin);
/// Returns the outline of a chain that tapers from root to tip. It follows the smooth curve through the chain's
/// points.
QPainterPath chainPath(const Canvas &canvas, const sim::State &state, const lessons::ChainView &chain);
/// Returns the outline of a limb with round ends.
QPainterPath limbPath(const Canvas &canvas, const sim::State &state, const lessons::LimbView &limb);

/// The style of moments other than the present one.
struct OutlineStyle
{
    QColor color;
    double width = 1.5;
    bool isDashed = true;
    QColor fill = Qt::transparent; ///< of closed shapes
};

/// Draws the outlines of a creature, without its tree.
void drawOutlines(const Canvas &canvas, const Figure &figure, const OutlineStyle &style);

}
