#pragma once

#include "sim/pipeline/method.h"

#include <vector>

namespace sim {

/// The kernels of a step, with the points that each works on.
struct StepKernel
{
    PointRange points;
    Kernel kernel;
};

/// The kernels of `phases` in order. Those that do the same to each of their points and follow each other as gravity, kick,
/// damping and move do (gravity and damping may be missing) become one, which goes through memory once and leaves the
/// same bits. It is for steps that nobody looks into.
std::vector<StepKernel> fusedKernels(const std::vector<Phase> &phases);

}
