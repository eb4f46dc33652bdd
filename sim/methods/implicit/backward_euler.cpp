#include "sim/methods/implicit/backward_euler.h"

namespace sim {

namespace {

// Shown lines are short.
// clang-format off
//! [backward_euler]
void backwardEuler(
    ImplicitStep &step, double h)
{
    auto &[x, v] = step.motion;
    step.tick(h);
    // with the pull at the new x:
    // v = keep (v + h a(x + h v))
    Numbers keep = step.kept(h);
    v = step.solve(
        x, keep * v, h, h * keep);
    x = x + h * v;
}
//! [backward_euler]
// clang-format on

}

BackwardEuler::StepFunction BackwardEuler::stepFunction() const
{
    return backwardEuler;
}

}
