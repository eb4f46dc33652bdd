#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

/// One scene and one view per step. The functions have the same names in all steps, so that the code of two
/// steps differs only in what is new. Point 0 is the foot, point 1 the body.
namespace two_body {

constexpr int foot = 0;
constexpr int body = 1;

namespace mutual {
sim::Scene setUp(const sim::Values &values);
lessons::View look(const sim::Scene &scene);
}
namespace leg_line {
sim::Scene setUp(const sim::Values &values);
lessons::View look(const sim::Scene &scene);
}

}
