#pragma once

#include "sim/analysis/stability/stability.h"
#include "sim/pipeline/pipeline.h"

#include <functional>
#include <string>
#include <vector>

/// What the suites of the stability gauge share: scenes, and steps measured by running.
namespace stability_bench {

/// A scene with what swings in it, and how to tell its energy.
struct Swinging
{
    sim::Scene scene;
    std::function<double(const sim::State &)> energy; ///< of motion and springs, px^2/frame^2
};

/// One point on a spring to a place.
Swinging onePoint(double k, double damp);
/// `points` in a row between two fixed places, each joined to the next by springs that both ends feel.
Swinging chain(int points, double k, double damp);
/// A body with feet around it at the distance that its springs want.
Swinging creature(int feet, double k, double damp);
/// The same with springs that want no distance, all in one place.
Swinging bundle(int feet, double k, double damp);

/// Body springs between bodies of several masses, of which one is slowed more than the others.
Swinging uneven();
/// More patterns of motion than are looked at exactly, and no two feet alike.
Swinging manyFeet();
/// A young tree whose joints are springs.
Swinging tree(double k, double damp);

/// The explicit methods of fixed step.
const std::vector<const char *> &explicitMethods();

/// The prediction for `method` at a step of h frames.
sim::Stability predicted(const sim::Scene &scene, const std::string &method, double h = 1.0);

/// Whether energy grows without end at steps of h frames (any number): a run from a disturbance of 1e-5 px, until its energy is 1e8 times as much or as little, or for `steps` steps.
bool grows(const Swinging &one, const std::string &method, double h, int steps = 40'000);

/// The smallest step at which it does: looked for from `from` upwards in steps of 4 %, then by bisection.
double onset(const Swinging &one, const std::string &method, double from);

}
