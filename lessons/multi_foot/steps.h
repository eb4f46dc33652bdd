#pragma once

#include "lessons/api/step.h"

namespace multi_foot {

lessons::Step twoFeetStep();
lessons::Step anyNumberStep();
lessons::Step grownFeetStep();

}
