#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
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
