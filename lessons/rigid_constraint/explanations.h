#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
namespace rigid_constraint {

lessons::Explanation pairExplanation();
lessons::Explanation sharedErrorExplanation();
lessons::Explanation triangleExplanation();
lessons::Explanation listExplanation();
lessons::Explanation verletExplanation();
lessons::Explanation ragdollExplanation();

}
