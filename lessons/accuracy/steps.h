#pragma once

#include "lessons/api/step.h"

namespace accuracy {

lessons::Step bigStep();
lessons::Step energyStep();
lessons::Step halveStep();
lessons::Step adaptStep();
lessons::Step bounceStep();
lessons::Step budgetStep();
lessons::Step crowdStep();

}
