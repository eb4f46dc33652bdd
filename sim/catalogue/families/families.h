#pragma once

#include "sim/catalogue/hard_case.h"

/// The families of hard cases.
namespace sim::hard {

std::vector<HardCase> stiffSprings();
std::vector<HardCase> manyFeet();
std::vector<HardCase> coincidentPoints();
std::vector<HardCase> suddenDrags();
std::vector<HardCase> wallsAndWalking();
std::vector<HardCase> rigidSticks();
std::vector<HardCase> swimmers();
std::vector<HardCase> windyTrees();
std::vector<HardCase> unusualSteps();
std::vector<HardCase> longRuns();
std::vector<HardCase> invalidInput();

/// Returns a case that runs `scene` with `values` for `frames` frames, in steps of one frame.
HardCase caseOf(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                Values values, std::int64_t frames);
/// Returns a case of one foot on a spring. It oscillates for ever without damping.
HardCase footOnSpringCase(const char *id, const char *title, const char *story, double k, double damp,
                          std::int64_t frames);
/// Adds that the foot of footOnSpringCase() comes to rest within `frames` frames.
HardCase comesToRest(HardCase hardCase, std::int64_t frames);

}
