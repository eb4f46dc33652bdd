#pragma once

#include "support.h"

#include "sim/analysis/accuracy/study.h"

namespace support {

/// Lets a study run to its end.
extern const sim::StudyProgress goOn;

/// Errors only: times are asked for by few tests.
sim::StudyPlan quickPlan(std::int64_t frames);

sim::Script scriptOf(const sim::Scene &scene, const sim::MethodSetup &setup);
/// With the method `published`.
sim::Script scriptOf(const sim::Scene &scene);

/// For messages.
std::string nameOf(const sim::AccuracyRow &row);

/// A damped spring, and where its ball is after t frames: x'' = -k x - c x' has the roots -c/2 +- i w.
inline constexpr sim::Vec2 spot = {270.0, 200.0};
sim::Scene dampedSpring();
sim::Vec2 onDampedSpring(double t);

}
