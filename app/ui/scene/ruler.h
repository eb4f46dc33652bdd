#pragma once

#include "sim/base/direction.h"

#include <QPointF>
#include <QRectF>

#include <optional>

namespace app {

struct Camera;
struct Canvas;

/// A line that the learner lays over the picture to measure with.
struct Ruler
{
    enum class End { from, to };

    sim::Vec2 from, to; ///< px of the scene

    double length() const; ///< px
    /// How far it is turned up from the right, counterclockwise, from -180 to 180 degrees (y points down); 0 where it
    /// has no length.
    double angle() const;
    sim::Vec2 &at(End end) { return end == End::from ? from : to; }
    /// The end that a press at `place` (px of the screen) takes, the far one of two in one place; none if it is off both.
    std::optional<End> endAt(const Camera &camera, QPointF place) const;
};

/// Draws the line with a tick every 10 px, its ends, and in words how long it is and which way it points. The words keep
/// off `scale`, px of the screen.
void drawRuler(const Canvas &canvas, const Ruler &ruler, const QRectF &scale);

}
