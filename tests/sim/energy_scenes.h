#pragma once

#include "support.h"

/// Scenes of the suites of energy and momentum.
namespace energy_bench {

using namespace sim;

/// A point of mass `mass` at (100, 50), at rest.
inline Scene lone(double mass)
{
    Scene scene = scenes::onePoint("foot", {100.0, 50.0});
    scene.start.inverseMass[0] = 1.0 / mass;
    return scene;
}

/// Two points that move one after the other in `published`, 60 px apart, on a spring of 50 px and stiffness k.
inline Scene pairOf(double k)
{
    Scene scene = scenes::springCreature(1, k, 50.0);
    scene.start.place(0, {240.0, 200.0});
    scene.start.place(1, {300.0, 210.0});
    scene.start.setVelocity(0, {1.0, -2.0});
    return scene;
}

inline double lengthOf(Vec2 a)
{
    return length(a);
}

}
