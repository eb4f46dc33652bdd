#pragma once

#include "sim/scene/scene.h"

/// A square of points on springs to their neighbours, which hangs by its top row.
namespace scenes::cloth {

constexpr double spacing = 5.0; ///< px, the springs' length
constexpr double weight = 0.5;  ///< px/frame^2

/// Stiffness (1/frame^2) and damping with which a cloth is stable under an explicit step of one frame.
constexpr double soft = 0.2, calm = 0.98;

/// Returns a cloth of `side` rows of `side` points, none of its springs stretched: its stiffness is `k` (1/frame^2), and
/// `damp` the share of a velocity that is left after each frame. Points are numbered from the left, row by row from the
/// top; those of the top row are handles.
sim::Scene hung(int side, double k, double damp);

}
