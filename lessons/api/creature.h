#pragma once

#include "lessons/api/look.h"
#include "sim/scene.h"

namespace lessons {

/// Widths in px, as published: Creatures I, step 17 (half of them counts at a wall).
constexpr double bodyWidth = 30.0;
constexpr double footWidth = 10.0;

/// Points "foot" (or "foot0", "foot1"... if there are several), then "body": all at (270, 200), mass 1, at rest.
/// The feet move before the body.
sim::Scene creature(int feet);

/// The same with a body that a hand can carry but no force moves.
sim::Scene creatureOnHandle();

/// Half of each point's width: feet, then the body.
Eigen::ArrayXd halfWidths(const sim::Scene &scene);

/// Feet and body as discs; with legs, a line from the body to each foot.
Look creatureLook(const sim::Scene &scene);
Look creatureLookWithLegs(const sim::Scene &scene);

}
