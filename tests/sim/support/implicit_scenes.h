#pragma once

#include "sim/scene/scene.h"

#include <functional>
#include <string>
#include <vector>

/// Scenes whose motion is smooth, and their end states by closed forms or by a solver that shares no code
/// with sim.
namespace implicit_scenes {

constexpr double gravity = 0.5; // px/frame^2

/// Positions and velocities of all points, or angles and spins of all branches.
struct Coordinates
{
    Eigen::ArrayXd x;
    Eigen::ArrayXd v;
};
Coordinates coordinatesOf(const sim::State &state);
/// Returns the largest difference of two corresponding numbers.
double distance(const Coordinates &a, const Coordinates &b);

struct SmoothScene
{
    std::string name;
    sim::Scene scene;
    std::function<Coordinates(int frames)> exact; ///< end state after `frames` frames, accurate to 1e-8
};
/// Returns springs, creatures in the air, swinging legs and a tree.
const std::vector<SmoothScene> &smoothScenes();

/// Returns a point on a spring to (0, 0).
sim::Scene oscillator(double k, double damp);
/// Returns a body with feet in the air, with springs, gravity and damping, in this order.
sim::Scene creature(int feet, double damp);
/// Returns a body in the air and two legs that swing with a gait clock.
sim::Scene walker(double damp);
/// Returns four points that hang on springs: p0 on the fixed point p4, p1 on the fixed point p5, p3 on p1,
/// and p2 on the position (120, 150).
sim::Scene hanging(double k, double damp);
/// Returns a small tree with spring joints in a gust.
sim::Scene windyTree();

}
