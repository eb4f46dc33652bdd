#pragma once

#include "lessons/api/step.h"
#include "sim/effects/tree/tree.h"

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

/// A step with what all steps of this lesson share: a tree that `grow` makes, drawn before a dusky sky. `id` is the
/// marker of its set-up, too.
lessons::Step treeStep(const char *id, const QString &title, sim::Tree (*grow)(const sim::Values &));

}
