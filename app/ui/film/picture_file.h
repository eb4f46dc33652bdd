#pragma once

#include "app/ui/scene/scene_view.h"

namespace app {

/// PNG pixels per screen pixel. A PNG is larger than the screen, so that it stays sharp in a document.
constexpr double pngScale = 2.0;

/// Writes the visible scene as an SVG if `path` ends in .svg, otherwise as a PNG.
/// @throws UserError if the file cannot be written
void savePicture(SceneView &view, const QString &path);

}
