#pragma once

#include "app/ui/scene/scene_view.h"

namespace app {

/// Each px of the screen is so many of a PNG's, so that it is sharp in a text, too.
constexpr double pngScale = 2.0;

/// Writes the scene as it is shown: `path` ends in .svg, or else it is a PNG. @throws Refusal: it was not written
void savePicture(SceneView &view, const QString &path);

}
