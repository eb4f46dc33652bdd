#pragma once

#include "lessons/api/step.h"

namespace single_spring {

lessons::Step dragStep();
lessons::Step fixedCentreStep();
lessons::Step movingBodyStep();
lessons::Step offsetStep();
lessons::Step radialStep();

}
