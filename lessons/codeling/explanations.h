#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
namespace codeling {

lessons::Explanation motorExplanation();
lessons::Explanation orientationExplanation();
lessons::Explanation anticipationExplanation();
lessons::Explanation squashStretchExplanation();
lessons::Explanation volumeExplanation();
lessons::Explanation tentaclesExplanation();

}
