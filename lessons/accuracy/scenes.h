#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

/// One scene per step (see lessons/README.md).
namespace accuracy {

/// The only point of scenes with one point, and the dynamic point of `adapt`.
constexpr int foot = 0;
/// px, the fixed end of the spring in `big_step` and `energy`.
constexpr sim::Vec2 centre = {270, 200};
/// px, radius of the ball in `bounce`.
constexpr double ballRadius = 15.0;

namespace big_step {
sim::Scene setUp(const sim::Values &values);
}
namespace energy {
sim::Scene setUp(const sim::Values &values);
}
namespace halve {
sim::Scene setUp(const sim::Values &values);
}
namespace adapt {
sim::Scene setUp(const sim::Values &values);
}
namespace bounce {
sim::Scene setUp(const sim::Values &values);
}
namespace budget {
sim::Scene setUp(const sim::Values &values);
}
namespace crowd {
/// Feet per creature.
constexpr int feet = 5;
/// Returns a room with its floor at 380 px that grows with the number of creatures, so that each has the same
/// area.
sim::Room roomFor(int count);
/// Returns the height above the floor up to which `count` creatures start, in px.
double heightFor(int count);
sim::Scene setUp(const sim::Values &values);
}

}
