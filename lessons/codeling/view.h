#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <vector>

/// How the scenes of this lesson look, what is drawn over them, and what is measured.
namespace codeling {

/// The lead with eyes; a line to its tail where there is one.
lessons::View spineLook(const sim::Scene &scene, const sim::Values &values);
/// The same with copies of where it was.
lessons::View stretchingLook(const sim::Scene &scene, const sim::Values &values);
/// A skin round lead, sides and tail; tentacles where there are any.
lessons::View bodyLook(const sim::Scene &scene, const sim::Values &values);

/// A cross at the target, and the motor's pull.
std::vector<lessons::Overlay> targetAndPull(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);

lessons::Measure anticipationMeasure();
lessons::Measure stretchMeasure();
lessons::Measure areaMeasure();
lessons::Measure widthMeasure();

}
