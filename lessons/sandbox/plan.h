#pragma once

#include "sim/effects/leg_spring.h"
#include "sim/effects/ramp.h"
#include "sim/effects/springs.h"
#include "sim/effects/walls.h"
#include "sim/scene.h"
#include "sim/values.h"

#include <memory>
#include <string>
#include <vector>

namespace sandbox {

/// What an empty sandbox begins with: a body that hangs from a nail.
std::shared_ptr<const sim::Blueprint> firstPlan();

/// The blueprint of a scene with these values: a file's, or the first one.
const sim::Blueprint &planOf(const sim::Values &values);

/// Whether the effect called `id` was chosen for the scene.
bool has(const sim::Blueprint &plan, const std::string &id);

/// The points alone: where they start, their masses and names. Those that are fixed feel nothing.
sim::Scene pointsOf(const sim::Blueprint &plan);

/// Half of each point's width, and all of it, in px.
Eigen::ArrayXd halfWidths(const sim::Blueprint &plan);
Eigen::ArrayXd widths(const sim::Blueprint &plan);

std::vector<sim::Spring> springsOf(const sim::Blueprint &plan);
std::vector<sim::Stick> sticksOf(const sim::Blueprint &plan);
/// The legs of gait group `gait`, and what they have in common.
std::vector<sim::Leg> legsOf(const sim::Blueprint &plan, int gait);
sim::LegRule ruleOf(const sim::BuiltGait &gait);
/// The points that are feet.
std::vector<int> feetOf(const sim::Blueprint &plan);

/// The clocks of a scene: one a gait group, then that of the wind, then one that no leg goes by.
constexpr double windClock = 0.05; ///< rad/frame, how fast the gusts come
int windClockOf(const sim::Blueprint &plan);
void setClocks(sim::Scene &scene, const sim::Blueprint &plan);
/// Which clock each point goes by, one a point.
std::vector<int> clockOf(const sim::Blueprint &plan);
/// For each clock those of the other gait groups with feet on the same bodies: one creature.
std::vector<std::vector<int>> matesOf(const sim::Blueprint &plan);
/// Whether any clock turns that something goes by.
bool hasClocks(const sim::Blueprint &plan, const sim::Values &values);

sim::Room roomOf(const sim::Values &values);
sim::Incline rampOf(const sim::Values &values);

}
