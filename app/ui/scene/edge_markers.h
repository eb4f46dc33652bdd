#pragma once

#include "app/ui/scene/canvas.h"

#include <vector>

namespace app {

/// A sign at the edge of the view for bodies that are outside: where to, and how far.
struct EdgeMarker
{
    int point = -1; ///< the nearest of the bodies that it stands for
    int bodies = 1;
    double away = 0.0; ///< px of the scene from the marker to that body
    QPointF at;        ///< the arrow's tip, on the screen
    QPointF direction; ///< to the body
    QString text;
    QRectF label;

    /// The box of the arrow.
    QRectF head() const;
    /// Whether a click at `place` means it: 24 px high at the least.
    bool contains(QPointF place) const { return head().united(label).adjusted(-4, -5, 4, 5).contains(place); }
};

/// The markers of all bodies that do not show in `view`, within `free`. Bodies in one direction share one.
/// The texts keep off `taken`.
std::vector<EdgeMarker> edgeMarkers(const Shown &shown, const Camera &camera, QRectF view, QRectF free,
                                    std::vector<QRectF> taken);

void drawEdgeMarkers(QPainter &painter, const Shown &shown, const Theme &theme,
                     const std::vector<EdgeMarker> &markers);

}
