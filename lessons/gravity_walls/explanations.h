#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace gravity_walls {

lessons::Explanation wallsExplanation();
lessons::Explanation gravityExplanation();

}
