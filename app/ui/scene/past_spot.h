#pragma once

#include "app/ui/scene/canvas.h"

#include <optional>

namespace app {

/// The frame of the earlier moment that is drawn at `place`, px of the screen, as a trail or as an onion skin; of several
/// the nearest. The figure itself is not part of its past.
std::optional<std::int64_t> pastFrameAt(const Shown &shown, const Camera &camera, QPointF place);

}
