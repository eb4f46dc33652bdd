#include "sim/methods/implicit/implicit_midpoint.h"

namespace sim {

namespace {

// Shown lines are short.
// clang-format off
//! [implicit_midpoint]
void implicitMidpoint(
    ImplicitStep &step, double h)
{
    auto &[x, v] = step.motion;
    Numbers keep = step.kept(h / 2);
    v = keep * v;
    step.tick(h / 2);
    // the velocity half way:
    // m = v + h/2 a(x + h/2 m)
    Numbers m = step.solve(x, v, h / 2);
    x = x + h * m;
    v = m + (m - v);
    step.tick(h / 2);
    v = keep * v;
}
//! [implicit_midpoint]
// clang-format on

}

ImplicitMidpoint::StepFunction ImplicitMidpoint::stepFunction() const
{
    return implicitMidpoint;
}

}
