#pragma once

#include "app/ui/scene/layers/scene_content.h"

#include <QRectF>

namespace app {

/// The smallest and the largest zoom of the scene. At zoom 1, one scene px is one screen px.
constexpr double leastZoom = 0.01;
constexpr double mostZoom = 16.0;
/// Screen px that stay free around the content.
constexpr double frameBorder = 24.0;

/// A zoom, and the scene position at the centre of the view, px.
struct Framing
{
    double zoom = 1.0;
    QPointF middle;
};

/// Returns the box of the bodies and positions that a step is about, with space to move, in scene px.
QRectF creatureArea(const Picture &picture);

/// Returns the area that a step shows first, in scene px: its creature, room or landscape, and `motion`. `motion` is
/// the area that its bodies will cross. It counts only near the rest, so that nothing looks tiny. The picture of
/// `companion` is empty if the step has none.
QRectF homeArea(const Picture &picture, const SceneContent &companion, const QRectF &motion);

/// Returns the box of the whole scene, in scene px: both stages (with the companion's), the room, `motion` and all
/// bodies.
QRectF wholeArea(const Picture &picture, const SceneContent &companion, const QRectF &motion);

/// Returns the largest zoom of the first view of a step, in a view of this size.
double mostAtHome(const lessons::View &view, QSizeF size);

/// Returns the framing of `area` in a view of this size, with a zoom of `most` at most. A floor or ground lies low in
/// the view, with space for the lines of text below it.
Framing framingOf(const lessons::View &view, const QRectF &area, QSizeF size, double most);

/// Returns the framing of a close-up of the creature that fills `area`, with space for its arrows. It includes only a
/// strip of a floor or ground below the creature, and only the near walls of a room.
Framing closeUp(const lessons::View &view, const QRectF &area, QSizeF size);

/// Returns the smallest change of a framing that brings `box` into the view. It zooms out, but not below `least`, and
/// then moves. `now` is the area that a view of this size shows inside its border, in scene px. Empty if `box` is too
/// large.
std::optional<Framing> widened(const lessons::View &view, const QRectF &now, const QRectF &box, QSizeF size,
                               double least);

}
