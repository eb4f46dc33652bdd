#pragma once

#include "app/ui/scene/drawing/canvas.h"

namespace app {

/// Returns the box of the caption in `view`: one line, or several if it wraps.
QRectF captionBox(const SceneContent &shown, const Camera &camera, QRectF view);
/// Returns the part of `view` that caption, scale and legends leave free.
QRectF freeArea(const SceneContent &shown, QRectF view);
/// Returns the free area between the walls of a room if there is enough space, otherwise the whole free area.
QRectF cardArea(const SceneContent &shown, const Camera &camera, QRectF view);

/// Returns whether the selected body shows a card instead of its name.
bool hasCard(const SceneContent &shown);
/// Returns the name of the selected body.
QString selectedName(const SceneContent &shown);
/// Returns where that name is in `view`; empty if the name is not shown. The place moves exactly as the body does.
QRectF namePlace(const SceneContent &shown, const Camera &camera, QRectF view);
/// Returns the box of the name, on whole pixels inside that place.
QRectF nameBox(const SceneContent &shown, const Camera &camera, QRectF view);

}
