#pragma once

#include "lessons/api/step.h"

namespace two_body {

lessons::Step mutualStep();
lessons::Step legLineStep();

}
