#pragma once

#include "lessons/api/step.h"

namespace walking_gait {

lessons::Step bonesStep();
lessons::Step legsStep();
lessons::Step feetBelowStep();
lessons::Step curvedLegsStep();
lessons::Step swingStep();
lessons::Step bodyPulledStep();
lessons::Step groundStep();
lessons::Step moreFeetStep();
lessons::Step steeringStep();
lessons::Step wallsStep();
lessons::Step companyStep();

}
