#pragma once

#include "sim/scene/scene.h"

#include <functional>
#include <string>
#include <vector>

/// Scenes that have a continuous limit, with where they end by formulas and a solver of the tests' own.
namespace implicit_scenes {

constexpr double gravity = 0.5; // px/frame^2

/// Where things are and how fast: places and velocities, or angles and spins.
struct Ends
{
    Eigen::ArrayXd x;
    Eigen::ArrayXd v;
};
Ends endsOf(const sim::State &state);
/// The largest difference of any number.
double distance(const Ends &a, const Ends &b);

struct SmoothScene
{
    std::string name;
    sim::Scene scene;
    std::function<Ends(int frames)> exact; ///< to 1e-8 or better
};
/// Swinging, creeping and undamped springs, creatures in the air, legs that swing, a tree.
const std::vector<SmoothScene> &smoothScenes();

/// A point on a spring to (0, 0).
sim::Scene oscillator(double k, double damp);
/// A body with feet in the air. Its effects: springs, gravity, damping.
sim::Scene creature(int feet, double damp);
/// A body and two legs that swing with a gait clock, in the air.
sim::Scene walker(double damp);
/// Four points that hang on springs: p0 on a hook, p4; p1 on another hook, p5; p3 on p1; p2 on the place (120, 150).
sim::Scene hanging(double k, double damp);
/// A small tree of springs in a gust that has come by.
sim::Scene windyTree();

}
