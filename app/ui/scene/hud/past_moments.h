#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <optional>

namespace app {

/// Returns the frame of the earlier moment drawn at `place` (screen px), as a trail or an onion skin. Returns the
/// nearest of several. The creature at the present moment does not count.
std::optional<std::int64_t> pastFrameAt(const SceneContent &shown, const Camera &camera, QPointF place);

}
