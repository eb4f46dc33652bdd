#pragma once

#include "lessons/api/step.h"

namespace hard_cases {

lessons::Step limitStep();
lessons::Step runawayStep();
lessons::Step manyFeetStep();
lessons::Step onePlaceStep();
lessons::Step stiffStep();
lessons::Step contradictionStep();
lessons::Step longRunStep();
lessons::Step tortureStep();

}
