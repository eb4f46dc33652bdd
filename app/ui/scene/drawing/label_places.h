#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <vector>

namespace app {

/// Finds positions for labels and cards where they cover no bodies, lines or other labels.
class LabelPlaces
{
public:
    /// `strokes`: lines already drawn, screen px.
    explicit LabelPlaces(std::vector<QRectF> taken, std::vector<QLineF> strokes = {})
        : m_taken(std::move(taken)), m_strokes(std::move(strokes))
    {
    }

    /// Returns a box of `size` near `anchor`, inside `area` if there is space for it. Later boxes avoid it.
    QRectF beside(QPointF anchor, QSizeF size, const QRectF &area);
    /// Returns the box of `size` within `area` that covers the least and is near `wanted` (its top left corner).
    QRectF within(QRectF area, QPointF wanted, QSizeF size);
    /// Adds a line that later boxes avoid.
    void takeStroke(const QLineF &line) { m_strokes.push_back(line); }
    /// Returns whether a box covers nothing.
    bool isFree(const QRectF &box) const { return covered(box) == 0.0; }

private:
    double covered(const QRectF &box) const;

    std::vector<QRectF> m_taken;
    std::vector<QLineF> m_strokes;
};

/// Returns the length of the part of `line` within `box`, px.
double lengthWithin(const QLineF &line, const QRectF &box);

/// Returns the bounding boxes of the bodies on the screen.
std::vector<QRectF> bodyBoxes(const SceneContent &shown, const Camera &camera);

}
