#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/look.h"

namespace rigid_constraint {

/// Points and sticks; the pointer carries the first point.
lessons::Look pointedLook(const sim::Scene &scene, const sim::Values &values);
/// Points and sticks in a room.
lessons::Look boxLook(const sim::Scene &scene, const sim::Values &values);
/// The same with flesh on them, and a head. A file's own figure has none.
lessons::Look ragdollLook(const sim::Scene &scene, const sim::Values &values);

lessons::Measure errorMeasure();
lessons::Measure stretchMeasure();

}
