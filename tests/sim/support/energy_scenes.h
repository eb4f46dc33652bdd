#pragma once

#include "tests/sim/support/support.h"

/// Scenes for the suites of energy and momentum.
namespace energy_scenes {

using namespace sim;

/// Returns a scene with one point of mass `mass` at rest at (100, 50).
inline Scene singlePoint(double mass)
{
    Scene scene = scenes::onePoint("foot", {100.0, 50.0});
    scene.start.inverseMass[0] = 1.0 / mass;
    return scene;
}

/// Returns two moving points about 60 px apart on a spring of length 50 px and stiffness k. The method
/// `published` moves one after the other.
inline Scene springPair(double k)
{
    Scene scene = scenes::springCreature(1, k, 50.0);
    scene.start.place(0, {240.0, 200.0});
    scene.start.place(1, {300.0, 210.0});
    scene.start.setVelocity(0, {1.0, -2.0});
    return scene;
}

}
