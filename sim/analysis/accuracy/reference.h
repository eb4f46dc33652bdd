#pragma once

#include "sim/analysis/accuracy/preview.h"

namespace sim {

/// px. The reference is valid while its check run is no farther away. Errors fifty times as large are then
/// known to 2 %. A tighter bound would gain little and would end chaotic runs earlier.
constexpr double referenceAgreement = 1e-6;

/// px, the same bound for self-refinement. Scenes with constraints or jumps reduce methods to low order. Runs
/// at fine steps then soon differ by a fraction of the error at coarse steps.
constexpr double selfAgreement = 1.0;

/// Computes the reference for the scene of `script` and the horizon up to which it is valid, and writes both
/// into `found`. Updates `preview` after each output step.
void findReference(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor,
                   Preview &preview);

/// Returns the finest step of 1/256, 1/128, ... 1/8 frame at which the script's method computes `frames`
/// frames within `seconds`. A refinement level is compared with that run if its step is at least four times
/// as long.
StepSize finestSelfStep(const Script &script, std::int64_t frames, double seconds, StudyMonitor &monitor);

}
