#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
namespace single_spring {

lessons::Explanation dragExplanation();
lessons::Explanation fixedCentreExplanation();
lessons::Explanation movingBodyExplanation();
lessons::Explanation offsetExplanation();
lessons::Explanation radialExplanation();

}
