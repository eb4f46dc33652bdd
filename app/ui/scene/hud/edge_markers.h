#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <vector>

namespace app {

/// A marker at the edge of the view for bodies outside it: their direction and distance.
struct EdgeMarker
{
    int point = -1; ///< the nearest body that it represents
    int bodies = 1;
    double away = 0.0; ///< scene px from the marker to that body
    QPointF at;        ///< the arrow's tip, on the screen
    QPointF direction; ///< towards the body
    QString text;
    QRectF label;

    /// Returns the box of the arrow.
    QRectF head() const;
    /// Returns whether a click at `place` hits the marker: the target is at least 24 px high.
    bool contains(QPointF place) const { return head().united(label).adjusted(-4, -5, 4, 5).contains(place); }
};

/// Returns the markers, within `free`, of all bodies outside `view`. Bodies in the same direction share a marker. The
/// texts avoid the boxes in `taken`.
std::vector<EdgeMarker> edgeMarkers(const SceneContent &shown, const Camera &camera, QRectF view, QRectF free,
                                    std::vector<QRectF> taken);

void drawEdgeMarkers(QPainter &painter, const SceneContent &shown, const Theme &theme,
                     const std::vector<EdgeMarker> &markers);

}
