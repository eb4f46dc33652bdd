#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace swaying_tree {

lessons::Explanation trunkExplanation();
lessons::Explanation branchesExplanation();
lessons::Explanation randomnessExplanation();
lessons::Explanation towardsPointerExplanation();
lessons::Explanation windExplanation();
lessons::Explanation restExplanation();
lessons::Explanation distanceExplanation();
lessons::Explanation thicknessExplanation();
lessons::Explanation turbulenceExplanation();
lessons::Explanation realSwayExplanation();

}
