#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new.
namespace accuracy {

/// The point of the scenes that have one point, and of `adapt`.
constexpr int foot = 0;
/// px: where the spring of the first two steps ends.
constexpr sim::Vec2 centre = {270, 200};
/// px: half of the ball's width.
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
/// Each of its creatures has so many feet.
constexpr int feet = 5;
/// A room on a floor at 380 px that leaves each of `count` creatures as much place, from the one as from the
/// other, and how high it is filled with them, in px.
sim::Room roomFor(int count);
double heightFor(int count);
sim::Scene setUp(const sim::Values &values);
}

}
