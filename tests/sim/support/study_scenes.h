#pragma once

#include "tests/sim/support/support.h"

#include "sim/analysis/accuracy/study.h"

namespace support {

/// Progress callback that never stops a study.
extern const sim::StudyProgress keepGoing;

/// Returns a plan that measures errors but no times.
sim::StudyPlan quickPlan(std::int64_t frames);

sim::Script scriptOf(const sim::Scene &scene, const sim::MethodSetup &setup);
/// Returns a script with the method `published`.
sim::Script scriptOf(const sim::Scene &scene);

/// Returns the row's method and step, for failure messages.
std::string nameOf(const sim::AccuracyRow &row);

/// Position of the spring's fixed end, px.
inline constexpr sim::Vec2 anchor = {270.0, 200.0};
/// Returns a ball on a damped spring.
sim::Scene dampedSpring();
/// Returns the ball's exact position after t frames, px. x'' = -k x - c x' has the roots -c/2 +- i w.
sim::Vec2 dampedSpringAt(double t);

}
