#pragma once

#include "sim/base/direction.h"

#include <QPointF>
#include <QRectF>

#include <optional>

namespace app {

struct Camera;
struct Canvas;

/// A line that the learner places over the scene to measure with.
struct Ruler
{
    enum class End { from, to };

    sim::Vec2 from, to; ///< scene px

    double length() const; ///< px
    /// Returns the angle to the x axis, counterclockwise, from -180 to 180 degrees (y points down). Returns 0 if the
    /// ruler has no length.
    double angle() const;
    sim::Vec2 &at(End end) { return end == End::from ? from : to; }
    /// Returns the end that a press at `place` (screen px) takes; empty if `place` is off both ends. If both ends
    /// coincide, it returns the `to` end.
    std::optional<End> endAt(const Camera &camera, QPointF place) const;
};

/// Draws the line with a tick every 10 px, its ends, and a text with its length and angle. The text avoids `scale`,
/// screen px.
void drawRuler(const Canvas &canvas, const Ruler &ruler, const QRectF &scale);

}
