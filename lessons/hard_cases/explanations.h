#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
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
