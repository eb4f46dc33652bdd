#pragma once

#include "app/ui/scene/drawing/canvas.h"
#include "lessons/api/explanation.h"

#include <vector>

namespace app {

/// Marks the subjects of a formula, with their lengths: a ring around a body, a cross at a place, arrows, and the sides of
/// right triangles. Parameters are marked in their panel.
void drawHighlights(const Canvas &canvas);

/// Returns the subjects as a list for screen readers: "foot 0, the arrow from body to foot 0".
QString highlightWords(const std::vector<lessons::Highlight> &highlights);

}
