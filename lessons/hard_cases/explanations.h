#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
namespace hard_cases {

lessons::Explanation limitExplanation();
lessons::Explanation runawayExplanation();
lessons::Explanation manyFeetExplanation();
lessons::Explanation onePlaceExplanation();
lessons::Explanation stiffExplanation();
lessons::Explanation contradictionExplanation();
lessons::Explanation longRunExplanation();
lessons::Explanation tortureExplanation();

}
