#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace multi_foot {

lessons::Explanation twoFeetExplanation();
lessons::Explanation anyNumberExplanation();
lessons::Explanation grownFeetExplanation();

}
