#pragma once

#include "app/ui/scene/canvas.h"

#include <QPainterPath>

namespace app {

/// One moment of a run, and how it is drawn. Both must outlive it.
struct Figure
{
    const lessons::View &look;
    const sim::State &state;
};

/// Where a spring ends that begins at point `a`.
sim::Vec2 endOf(const lessons::SpringView &spring, const sim::State &state);
/// The straight legs that can show.
QList<QLineF> straightLegs(const Canvas &canvas, const Figure &figure);
/// The curved legs that can show: from the foot, quadratic, to the body, with the control point above the foot.
QPainterPath curvedLegs(const Canvas &canvas, const Figure &figure);
/// The smooth closed curve through the points of a skin (Catmull and Rom, "A class of local interpolating
/// splines", 1974, as cubics).
QPainterPath skinPath(const Canvas &canvas, const sim::State &state, const lessons::SkinView &skin);
/// The outline of a chain that gets thinner from its root to its tip, along the smooth curve through its points.
QPainterPath chainPath(const Canvas &canvas, const sim::State &state, const lessons::ChainView &chain);
/// The outline of a limb with round ends.
QPainterPath limbPath(const Canvas &canvas, const sim::State &state, const lessons::LimbView &limb);

/// How moments are drawn that are not the present one.
struct OutlineStyle
{
    QColor color;
    double width = 1.5;
    bool isDashed = true;
    QColor fill = Qt::transparent; ///< of what has an inside
};

/// All of a figure but its tree, as outlines.
void drawOutlines(const Canvas &canvas, const Figure &figure, const OutlineStyle &style);

}
