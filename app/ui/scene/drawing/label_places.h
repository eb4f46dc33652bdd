#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <vector>

namespace app {

/// Finds positions for labels and cards where they cover no bodies, lines or other labels. The same position is found again
/// for a thing that has moved by a rounding error only: of positions that are as good, the first one counts.
class LabelPlaces
{
public:
    /// `strokes`: lines already drawn, screen px.
    explicit LabelPlaces(std::vector<QRectF> taken, std::vector<QLineF> strokes = {})
        : m_taken(std::move(taken)), m_strokes(std::move(strokes))
    {
    }

    /// Returns a box of `size` near `anchor`, inside `area` (at its left and top edge if `area` is smaller). Later boxes avoid it.
    QRectF beside(QPointF anchor, QSizeF size, const QRectF &area);
    /// Returns the box of `size` within `area` that covers the least and is near `wanted` (its top left corner).
    QRectF within(QRectF area, QPointF wanted, QSizeF size);
    /// Adds a line that later boxes avoid.
    void takeStroke(const QLineF &line) { m_strokes.push_back(line); }
    /// Adds a box that later boxes avoid.
    void take(const QRectF &box) { m_taken.push_back(box); }
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
/// Returns the lines of springs, sticks and legs on the screen, from centre to centre. Empty if there are very many.
std::vector<QLineF> linkLines(const SceneContent &shown, const Camera &camera);

}
