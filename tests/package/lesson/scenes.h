#pragma once

#include "sim/forward.h"
#include "sim/scene/state.h"

constexpr sim::Vec2 planet = {270.0, 200.0}; ///< px

sim::Scene setUp(const sim::Values &values);
