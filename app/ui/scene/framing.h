#pragma once

#include "app/ui/scene/shown.h"

#include <QRectF>

namespace app {

/// The least and the largest zoom of the scene; 1: a px of the scene is one of the screen.
constexpr double leastZoom = 0.01;
constexpr double mostZoom = 16.0;
/// px of the screen that stay free round what is shown.
constexpr double frameBorder = 24.0;

/// A zoom, and the place of the scene that is in the middle of the view, px.
struct Framing
{
    double zoom = 1.0;
    QPointF middle;
};

/// Returns bodies and places that a step is about, with room to move, in px of the scene.
QRectF creatureArea(const Picture &picture);

/// Returns what a step shows first, in px of the scene: its creature, room or landscape, and `motion`, the way that its
/// bodies will go, as far as that does not make all else tiny. `beside`: the companion.
QRectF homeArea(const Picture &picture, const Shown &beside, const QRectF &motion);

/// Returns all that there is to show, in px of the scene: the stage, the companion's, the room, `motion` and all
/// bodies.
QRectF wholeArea(const Picture &picture, const Shown &beside, const QRectF &motion);

/// Returns how far what a step shows first is enlarged at most, in a view of this size.
double mostAtHome(const lessons::View &look, QSizeF view);

/// Returns how `area` is shown in a view of this size, enlarged by `most` at most. A floor or ground lies low in the view,
/// with room for the lines of text below it.
Framing framingOf(const lessons::View &look, const QRectF &area, QSizeF view, double most);

/// Returns how a creature that fills `area` is shown large, with room for its arrows. Of a floor or ground below it only
/// so much is shown, and of a room the walls that are near.
Framing closeUp(const lessons::View &look, const QRectF &area, QSizeF view);

/// Returns the smallest change of a framing that brings `box` into the view: it zooms out, to `least` at the least, and
/// beyond that it moves. `now` is what a view of this size shows inside its border, in px of the scene. Empty if `box` is
/// too large for that.
std::optional<Framing> widened(const lessons::View &look, const QRectF &now, const QRectF &box, QSizeF view,
                               double least);

}
