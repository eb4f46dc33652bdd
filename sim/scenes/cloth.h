#pragma once

#include "sim/scene/scene.h"

/// A square cloth of points and springs that hangs by its top row.
namespace scenes::cloth {

constexpr double spacing = 5.0; ///< px, rest length of the springs
constexpr double weight = 0.5;  ///< px/frame^2, gravity

/// Stiffness (mass/frame^2) and damping factor of a cloth that is stable under explicit steps of one frame.
constexpr double soft = 0.2, calm = 0.98;

/// Returns a cloth of `side` rows of `side` points, with all springs at their rest length. `k`: stiffness
/// (mass/frame^2). `damp`: damping factor per frame. Points are numbered from left to right, row by row from
/// the top. Those of the top row are handles.
sim::Scene hung(int side, double k, double damp);

}
