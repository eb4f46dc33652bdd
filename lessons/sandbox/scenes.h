#pragma once

#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/springs.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <memory>
#include <string>
#include <vector>

/// The scene that a learner builds, set up from its blueprint.
namespace sandbox {

/// Returns the blueprint that a new sandbox starts with: a body that hangs on a spring from a fixed point.
std::shared_ptr<const sim::Blueprint> defaultBlueprint();

/// Returns the blueprint in `values`, or the default blueprint if there is none.
const sim::Blueprint &planOf(const sim::Values &values);

/// Returns a scene of the points alone, without effects. Fixed points are not dynamic.
sim::Scene pointsOf(const sim::Blueprint &plan);

std::vector<sim::Spring> springsOf(const sim::Blueprint &plan);
std::vector<sim::Stick> sticksOf(const sim::Blueprint &plan);
/// Returns the legs of gait group `gait`.
std::vector<sim::Leg> legsOf(const sim::Blueprint &plan, int gait);
/// Returns the rule that the legs of `gait` share.
sim::LegRule ruleOf(const sim::BlueprintGait &gait);

constexpr double windClock = 0.05; ///< rad/frame, speed of the clock of the gusts
/// Sets the start angles and speeds of the gait clocks, of the gusts' clock if there is a breeze, and of the rule's clock
/// if the rule reads the time.
void setClocks(sim::Scene &scene, const sim::Blueprint &plan);
/// Returns whether any clock that feet, gusts or the rule follow is turning.
bool hasClocks(const sim::Blueprint &plan, const sim::Values &values);

namespace build {
sim::Scene setUp(const sim::Values &values);
}

}
