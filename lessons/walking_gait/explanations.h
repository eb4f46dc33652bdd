#pragma once

#include "lessons/api/explanation.h"

/// What each step tells besides its narration: what a learner knows afterwards, words, and the why of its mathematics.
namespace walking_gait {

lessons::Explanation bonesExplanation();
lessons::Explanation legsExplanation();
lessons::Explanation feetBelowExplanation();
lessons::Explanation curvedLegsExplanation();
lessons::Explanation swingExplanation();
lessons::Explanation bodyPulledExplanation();
lessons::Explanation groundExplanation();
lessons::Explanation moreFeetExplanation();
lessons::Explanation steeringExplanation();
lessons::Explanation wallsExplanation();
lessons::Explanation companyExplanation();

}
