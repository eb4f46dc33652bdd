#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace accuracy {

lessons::Explanation bigStepExplanation();
lessons::Explanation energyExplanation();
lessons::Explanation halveExplanation();
lessons::Explanation adaptExplanation();
lessons::Explanation bounceExplanation();
lessons::Explanation budgetExplanation();
lessons::Explanation crowdExplanation();

}
