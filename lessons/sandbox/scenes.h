#pragma once

#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/springs.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <memory>
#include <string>
#include <vector>

/// The scene that somebody builds, from its plan.
namespace sandbox {

/// What an empty sandbox begins with: a body that hangs from a nail.
std::shared_ptr<const sim::Blueprint> firstPlan();

/// The blueprint of a scene with these values: a file's, or the first one.
const sim::Blueprint &planOf(const sim::Values &values);

/// The points alone: where they start, their masses and names. Those that are fixed feel nothing.
sim::Scene pointsOf(const sim::Blueprint &plan);

std::vector<sim::Spring> springsOf(const sim::Blueprint &plan);
std::vector<sim::Stick> sticksOf(const sim::Blueprint &plan);
/// The legs of gait group `gait`, and what they have in common.
std::vector<sim::Leg> legsOf(const sim::Blueprint &plan, int gait);
sim::LegRule ruleOf(const sim::BlueprintGait &gait);

constexpr double windClock = 0.05; ///< rad/frame, how fast the gusts come
void setClocks(sim::Scene &scene, const sim::Blueprint &plan);
/// Whether any clock turns that something goes by.
bool hasClocks(const sim::Blueprint &plan, const sim::Values &values);

namespace build {
sim::Scene setUp(const sim::Values &values);
}

}
