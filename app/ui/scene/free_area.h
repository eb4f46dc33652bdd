#pragma once

#include "app/ui/scene/canvas.h"

namespace app {

/// Where the caption stands in `view`: a line or more, broken where the width asks for it.
QRectF captionBox(const Shown &shown, const Camera &camera, QRectF view);
/// The part of `view` that caption, scale and legends leave free.
QRectF freeArea(const Shown &shown, QRectF view);
/// The same, between the walls of a room if there is room enough.
QRectF cardArea(const Shown &shown, const Camera &camera, QRectF view);

/// Whether a card stands beside the selected body, in place of its name.
bool hasCard(const Shown &shown);
/// What the selected body is called.
QString selectedName(const Shown &shown);
/// Where that name stands in `view`; empty if it does not.
QRectF nameBox(const Shown &shown, const Camera &camera, QRectF view);

}
