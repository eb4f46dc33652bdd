#pragma once

#include "sim/analysis/accuracy/preview.h"

namespace sim {

/// px: a reference holds as long as its check is no farther off. Errors fifty times as large are then known to 2
/// percent; a tighter bound would gain little and end chaotic runs earlier.
constexpr double referenceAgreement = 1e-6;

/// px: the same where methods are compared with their own finer steps. Those are of low order there (constraints,
/// jumps), and part from the next coarser ones soon, by a share of what their coarse steps are off.
constexpr double selfAgreement = 1.0;

/// Finds what errors on the scene of `script` can be measured against, and up to which frame; writes both into
/// `found`. After each frame `preview` may have a look.
void findReference(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor,
                   Preview &preview);

/// The finest step at which the script's method runs over `frames` frames within `seconds`: 1/256, or 1/128... down
/// to 1/8. Each rung is compared with that, if it is at least four times coarser.
StepSize finestSelfStep(const Script &script, std::int64_t frames, double seconds, StudyMonitor &monitor);

}
