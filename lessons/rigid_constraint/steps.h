#pragma once

#include "lessons/api/step.h"

namespace rigid_constraint {

lessons::Step pairStep();
lessons::Step sharedErrorStep();
lessons::Step triangleStep();
lessons::Step listStep();
lessons::Step verletStep();
lessons::Step ragdollStep();

}
