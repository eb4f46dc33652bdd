#pragma once

#include "sim/effects/constraints/area_stick.h"
#include "sim/effects/constraints/soft_sticks.h"
#include "sim/effects/constraints/stick.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <vector>

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new.
namespace codeling {

/// The points that every swimmer numbers alike.
constexpr int lead = 0;
constexpr int tail = 1;
constexpr int side0 = 2;
constexpr int side1 = 3;
constexpr int firstOfTentacles = 4;

/// How wide the body is at rest, and from which spine length on its sides keep its area, px.
constexpr double restWidth = 30.0;
constexpr double shortestSpine = 10.0;
/// How long a link of a tentacle is, px.
constexpr double linkLength = 7.0;

/// The corners of the body.
constexpr sim::Quad corners = {lead, tail, side0, side1};

/// The lead alone at (200, 200), and the target where the parameters say.
sim::Scene swimmer(const sim::Values &values);
/// The tail, `rest_length` px to the left of the lead.
void addTail(sim::Scene &scene, const sim::Values &values, sim::Motion motion);
/// Two sides, `restWidth` px apart, in the middle of lead and tail. They have no velocity.
void addSides(sim::Scene &scene);
/// Chains `tentacle0_0`, `tentacle0_1`... that start at the sides in turn and spread out behind.
/// Returns their links, from root to tip, chain after chain. A link's outer end takes its whole error.
std::vector<sim::Stick> addTentacles(sim::Scene &scene, int tentacles, int links);

/// The two soft sticks from lead and tail to each side.
std::vector<sim::SoftStick> sideSticks(const sim::Values &values);
/// The area of the body at rest, px^2.
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
