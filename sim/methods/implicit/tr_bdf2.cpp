#include "sim/methods/implicit/tr_bdf2.h"

#include <cmath>

namespace sim {

namespace {

// Shown lines are short.
// clang-format off
//! [tr_bdf2]
void trBdf2(ImplicitStep &step, double h)
{
    auto &[x, v] = step.motion;
    Numbers keep = step.kept(h / 2);
    v = keep * v;
    // trapezoid, to 0.586 h
    double gamma = 2 - std::sqrt(2);
    double half = gamma / 2 * h;
    Numbers a = step.accelerations(x);
    step.tick(gamma * h);
    Numbers v1 = step.solve(
        x + half * v, v + half * a, half);
    Numbers x1 = x + half * (v + v1);
    // from both places to h
    double past =
        1 / (gamma * (2 - gamma));
    step.tick((1 - gamma) * h);
    Numbers from = x + past * (x1 - x);
    v = step.solve(
        from, v + past * (v1 - v), half);
    x = from + half * v;
    v = keep * v;
}
//! [tr_bdf2]
// clang-format on

}

TrBdf2::StepFunction TrBdf2::stepFunction() const
{
    return trBdf2;
}

}
