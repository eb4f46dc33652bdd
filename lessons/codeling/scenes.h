#pragma once

#include "sim/effects/constraints/area_stick.h"
#include "sim/effects/constraints/soft_sticks.h"
#include "sim/effects/constraints/stick.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <vector>

/// One scene per step (see lessons/README.md).
namespace codeling {

/// Point indices, the same in all scenes that have these points.
constexpr int lead = 0;
constexpr int tail = 1;
constexpr int side0 = 2;
constexpr int side1 = 3;
constexpr int firstOfTentacles = 4;

/// px, width of the body at rest.
constexpr double restWidth = 30.0;
/// px. For the width of the body, a shorter spine counts as this long.
constexpr double shortestSpine = 10.0;
/// px, length of a link of a tentacle.
constexpr double linkLength = 7.0;

/// The corners of the body.
constexpr sim::Quad corners = {lead, tail, side0, side1};

/// Returns a scene with the lead at (200, 200) and the target at `target_x`, `target_y`.
sim::Scene swimmer(const sim::Values &values);
/// Adds the tail, `rest_length` px to the left of the lead.
void addTail(sim::Scene &scene, const sim::Values &values, sim::Motion motion);
/// Adds two sides, `restWidth` px apart, in the middle between lead and tail. Their motion is prescribed.
void addSides(sim::Scene &scene);
/// Adds chains of points `tentacle0_0`, `tentacle0_1`... which fan out behind the sides. The first half
/// starts at side 0, the rest at side 1. Returns the links as sticks, from root to tip, chain after chain.
/// The outer end of a link takes its whole error.
std::vector<sim::Stick> addTentacles(sim::Scene &scene, int tentacles, int links);

/// Returns four soft sticks: from lead and tail to each side.
std::vector<sim::SoftStick> sideSticks(const sim::Values &values);
/// Returns the area of the body at rest, in px^2.
double restArea(const sim::Values &values);

namespace motor {
sim::Scene setUp(const sim::Values &values);
}
namespace orientation {
sim::Scene setUp(const sim::Values &values);
}
namespace anticipation {
sim::Scene setUp(const sim::Values &values);
}
namespace squash_stretch {
sim::Scene setUp(const sim::Values &values);
}
namespace volume {
sim::Scene setUp(const sim::Values &values);
}
namespace tentacles {
sim::Scene setUp(const sim::Values &values);
}

}
