#pragma once

#include "sim/catalogue/hard_case.h"

/// The catalogue, a family of cases at a time.
namespace sim::hard {

std::vector<HardCase> stiffSprings();
std::vector<HardCase> manyFeet();
std::vector<HardCase> crampedPlaces();
std::vector<HardCase> roughHands();
std::vector<HardCase> wallsAndWalking();
std::vector<HardCase> rigidSticks();
std::vector<HardCase> swimmers();
std::vector<HardCase> windyTrees();
std::vector<HardCase> oddSteps();
std::vector<HardCase> longRuns();
std::vector<HardCase> badInput();

/// A case that runs `scene` with `values` for `frames` frames, by steps of one.
HardCase caseOf(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                Values values, std::int64_t frames);

}
