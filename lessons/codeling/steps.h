#pragma once

#include "lessons/api/step.h"

namespace codeling {

lessons::Step motorStep();
lessons::Step orientationStep();
lessons::Step anticipationStep();
lessons::Step squashStretchStep();
lessons::Step volumeStep();
lessons::Step tentaclesStep();

}
