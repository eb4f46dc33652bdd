#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"
#include "sim/scene/scene.h"
#include "sim/scenes/points.h"

/// Small scenes for what a look can say, each with points that go where a formula puts them.
namespace drawn_scenes {

/// A step that has nothing but a scene and a look.
lessons::Step step(const char *id, const sim::Scene &scene, const lessons::View &view);

/// All points go on by `velocity`, px/frame.
void letGlide(sim::Scene &scene, sim::Vec2 velocity);
/// A look with one foot a point.
lessons::View feetOnly(const sim::Scene &scene);

/// A tree that forks `forks` times: 2^(forks + 1) - 1 branches, the trunk 100 px long and from (270, 400) straight
/// up, children 0.8 times as long, 0.68 times as thick, and 28 degrees to either side.
struct Tree
{
    sim::Scene scene;
    lessons::View view;
};
Tree tree(int forks);
/// All branches turn to and fro, the thinner the farther.
void letSway(Tree &tree);

}
