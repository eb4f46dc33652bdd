#pragma once

#include "lessons/api/teaching.h"

namespace codeling {

/// What is told about the steps besides their narrations: hints, words, and the why of their mathematics.
std::vector<lessons::Teaching> teaching();

}
