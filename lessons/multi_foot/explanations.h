#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
namespace multi_foot {

lessons::Explanation twoFeetExplanation();
lessons::Explanation anyNumberExplanation();
lessons::Explanation grownFeetExplanation();

}
