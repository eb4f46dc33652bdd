#pragma once

#include "sim/scene/scene.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lessons {

/// Widths in px, as published: Creatures I, step 17 (half of them counts at a wall).
constexpr double bodyWidth = 30.0;
constexpr double footWidth = 10.0;

/// Points "foot" (or "foot0", "foot1"... if there are several), then "body": all at (270, 200), mass 1, at rest.
/// The feet move before the body.
sim::Scene creature(int feet);

/// The same with a body that a hand can carry but no force moves.
sim::Scene creatureOnHandle();

/// The same with feet that are numbered even when there is only one: "foot0".
sim::Scene creatureWithFeet(int feet);

/// The same with a body that a hand can carry but no force moves.
sim::Scene creatureWithFeetOnHandle(int feet);

/// Several such creatures in one scene: "creature0.foot0", "creature0.foot1"..., "creature0.body",
/// "creature1.foot0"... Each moves its feet, then its body, before the next creature moves.
sim::Scene crowd(int creatures, int feet);

/// The same creatures in another order: all bodies, then all first feet, all second feet and so on, so that what
/// creatures have alike lies side by side. All feet move, then all bodies.
sim::Scene crowdByParts(int creatures, int feet);

/// One point, "foot", at (270, 200), and no body.
sim::Scene loneFoot();

/// Adds an effect to those that act in `scene`, after the ones added before.
template <class Effect, class... Arguments>
void add(sim::Scene &scene, Arguments &&...arguments)
{
    scene.effects.push_back(std::make_shared<const Effect>(std::forward<Arguments>(arguments)...));
}

/// Puts foot 0, 1, 2... where `places` says (px), and the feet beyond those evenly on a circle round the body,
/// `spareDistance` px away from it.
constexpr double spareDistance = 60.0;
void placeFeet(sim::Scene &scene, const std::vector<sim::Vec2> &places);

/// Half of each point's width in px.
Eigen::ArrayXd halfWidths(const sim::Scene &scene);

/// Whether the point called `name` is a creature's body.
bool isBody(const std::string &name);

}
