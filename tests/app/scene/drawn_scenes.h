#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/scene/scene.h"
#include "sim/scenes/points.h"

/// Small scenes for the features of a view. A formula moves their points.
namespace drawn_scenes {

/// Returns a step that has nothing but a scene and a view.
lessons::Step step(const char *id, const sim::Scene &scene, const lessons::View &view);

/// Moves all points by `velocity`, px/frame.
void letGlide(sim::Scene &scene, sim::Vec2 velocity);
/// Returns a view that shows each point as a foot.
lessons::View feetOnly(const sim::Scene &scene);

/// A tree that forks `forks` times: 2^(forks + 1) - 1 branches, the trunk 100 px long and from (270, 400) straight
/// up, children 0.8 times as long, 0.68 times as thick, and 28 degrees to either side.
struct Tree
{
    sim::Scene scene;
    lessons::View view;
};
Tree tree(int forks);
/// Turns all branches to and fro, thin ones farther.
void letSway(Tree &tree);

}
