#pragma once

#include "app/ui/scene/canvas.h"

#include <vector>

namespace app {

/// Finds places for labels and cards where they cover neither bodies nor strokes nor each other.
class LabelPlaces
{
public:
    /// `strokes` are lines that are drawn, px.
    explicit LabelPlaces(std::vector<QRectF> taken, std::vector<QLineF> strokes = {})
        : m_taken(std::move(taken)), m_strokes(std::move(strokes))
    {
    }

    /// A box of `size` near `anchor`, all of it in `area` where there is room; taken from then on.
    QRectF beside(QPointF anchor, QSizeF size, const QRectF &area);
    /// The box of `size` within `area` that covers the least and is near `wanted` (its top left corner).
    QRectF within(QRectF area, QPointF wanted, QSizeF size);
    /// A line that is drawn from then on.
    void takeStroke(const QLineF &line) { m_strokes.push_back(line); }
    /// Whether a box covers nothing.
    bool isFree(const QRectF &box) const { return covered(box) == 0.0; }

private:
    double covered(const QRectF &box) const;

    std::vector<QRectF> m_taken;
    std::vector<QLineF> m_strokes;
};

/// How much of `line` lies within `box`, in px.
double lengthWithin(const QLineF &line, const QRectF &box);

/// The boxes that the bodies fill on the screen.
std::vector<QRectF> bodyBoxes(const Shown &shown, const Camera &camera);

}
