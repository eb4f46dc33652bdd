#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
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
