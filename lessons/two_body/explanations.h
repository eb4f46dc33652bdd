#pragma once

#include "lessons/api/explanation.h"

/// The explanations of the steps: what a learner learns, new terms, and the reasons behind the mathematics.
namespace two_body {

lessons::Explanation mutualExplanation();
lessons::Explanation legLineExplanation();

}
