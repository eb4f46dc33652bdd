#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <vector>

/// The views, overlays and measures of this lesson.
namespace codeling {

/// Returns a view of the lead with eyes, and a line to its tail if there is one.
lessons::View spineView(const sim::Scene &scene, const sim::Values &values);
/// Returns a spineView() with onion skins.
lessons::View stretchingView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view with a skin round lead, sides and tail, and tentacles if there are any.
lessons::View bodyView(const sim::Scene &scene, const sim::Values &values);

/// Returns a cross at the target and an arrow for the motor's pull.
std::vector<lessons::Overlay> targetAndPull(const sim::Scene &scene, const sim::State &state,
                                            const sim::Values &values);

/// Returns the distance from lead to target, px.
lessons::Measure anticipationMeasure();
/// Returns the length of the spine divided by its length at rest.
lessons::Measure stretchMeasure();
/// Returns the area of the body divided by its area at rest.
lessons::Measure areaMeasure();
/// Returns the distance between the sides, px.
lessons::Measure widthMeasure();

}
