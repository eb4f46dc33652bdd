#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace codeling {

lessons::Explanation motorExplanation();
lessons::Explanation orientationExplanation();
lessons::Explanation anticipationExplanation();
lessons::Explanation squashStretchExplanation();
lessons::Explanation volumeExplanation();
lessons::Explanation tentaclesExplanation();

}
