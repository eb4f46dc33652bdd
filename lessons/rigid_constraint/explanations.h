#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace rigid_constraint {

lessons::Explanation pairExplanation();
lessons::Explanation sharedErrorExplanation();
lessons::Explanation triangleExplanation();
lessons::Explanation listExplanation();
lessons::Explanation verletExplanation();
lessons::Explanation ragdollExplanation();

}
