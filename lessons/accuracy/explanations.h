#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
namespace accuracy {

lessons::Explanation bigStepExplanation();
lessons::Explanation energyExplanation();
lessons::Explanation halveExplanation();
lessons::Explanation adaptExplanation();
lessons::Explanation bounceExplanation();
lessons::Explanation budgetExplanation();
lessons::Explanation crowdExplanation();

}
