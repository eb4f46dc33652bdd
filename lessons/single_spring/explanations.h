#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace single_spring {

lessons::Explanation dragExplanation();
lessons::Explanation fixedCentreExplanation();
lessons::Explanation movingBodyExplanation();
lessons::Explanation offsetExplanation();
lessons::Explanation radialExplanation();

}
