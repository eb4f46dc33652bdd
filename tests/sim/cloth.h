#pragma once

#include "sim/scene/scene.h"

/// A square of points on springs to their neighbours, which hangs by its top row.
namespace cloth {

constexpr double spacing = 5.0; ///< px, the springs' length
constexpr double weight = 0.5;  ///< px/frame^2

/// Stiffness (1/frame^2) and damping of a cloth that an explicit step of a frame holds.
constexpr double soft = 0.2, calm = 0.98;

/// `side` points a side, of mass 1, all springs unstretched. Points are numbered from the left, row by row from the
/// top; those of the top row are handles.
sim::Scene hung(int side, double k, double damp);

/// Where row `row` hangs at rest, in px below where it is unstretched: each spring of a column carries all that is
/// below it, so that the m-th is stretched by weight (side - m) / k.
double sag(int side, double k, int row);

}
