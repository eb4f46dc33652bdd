#pragma once

#include "sim/pipeline/method.h"

#include <vector>

namespace sim {

/// A kernel of a step and the points that it works on.
struct StepKernel
{
    PointRange points;
    Kernel kernel;
};

/// Returns the kernels of `phases` in order. Each sequence of gravity, kick, damping and move on the same
/// points becomes one kernel; gravity and damping may be missing. The fused kernel passes through memory once
/// instead of four times and gives the same bits. It serves steps that run without stopping between phases.
std::vector<StepKernel> fusedKernels(const std::vector<Phase> &phases);

}
