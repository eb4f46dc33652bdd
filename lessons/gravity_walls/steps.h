#pragma once

#include "lessons/api/step.h"

namespace gravity_walls {

lessons::Step wallsStep();
lessons::Step gravityStep();

}
