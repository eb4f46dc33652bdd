#pragma once

#include "lessons/api/step.h"

namespace swaying_tree {

lessons::Step trunkStep();
lessons::Step branchesStep();
lessons::Step randomnessStep();
lessons::Step towardsPointerStep();
lessons::Step windStep();
lessons::Step restStep();
lessons::Step distanceStep();
lessons::Step thicknessStep();
lessons::Step turbulenceStep();
lessons::Step realSwayStep();

}
