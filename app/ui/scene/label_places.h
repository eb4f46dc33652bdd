#pragma once

#include "app/ui/scene/canvas.h"

#include <vector>

namespace app {

/// Finds places for labels and cards where they cover neither bodies nor each other.
class LabelPlaces
{
public:
    explicit LabelPlaces(std::vector<QRectF> taken) : m_taken(std::move(taken)) {}

    /// A box of `size` near `anchor`; taken from then on.
    QRectF beside(QPointF anchor, QSizeF size);
    /// The box of `size` within `area` that covers the least and is near `wanted` (its top left corner).
    QRectF within(QRectF area, QPointF wanted, QSizeF size);

private:
    double covered(const QRectF &box) const;

    std::vector<QRectF> m_taken;
};

/// The boxes that the bodies fill on the screen.
std::vector<QRectF> bodyBoxes(const Shown &shown, const Camera &camera);

}
