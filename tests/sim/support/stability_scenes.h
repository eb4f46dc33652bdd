#pragma once

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/analysis/stability/stability.h"
#include "sim/pipeline/pipeline.h"

#include <functional>
#include <string>
#include <vector>

/// Scenes for the suites of stability, and their stability limits measured by running them.
namespace stability_scenes {

/// A scene of springs and a measure of its energy.
struct OscillatingScene
{
    sim::Scene scene;
    std::function<double(const sim::State &)> energy; ///< kinetic and stored energy, px^2/frame^2
};

/// Returns one point on a spring to a position.
OscillatingScene onePoint(double k, double damp);
/// Returns a chain of `points` points between two fixed positions. Both ends of each spring feel it.
OscillatingScene chain(int points, double k, double damp);
/// Returns a body with feet around it, each at the rest length of its spring.
OscillatingScene creature(int feet, double k, double damp);
/// Returns a body with feet on springs of rest length 0, all at one position.
OscillatingScene bundle(int feet, double k, double damp);

/// Returns a chain of points of different masses, one of which is damped more than the others.
OscillatingScene uneven();
/// Returns a creature with feet of different masses and more modes than stabilityOf() analyses exactly.
OscillatingScene manyFeet();
/// Returns a small tree with spring joints.
OscillatingScene tree(double k, double damp);

/// Returns the ids of the explicit methods with a fixed step.
const std::vector<const char *> &explicitMethods();

/// Returns the predicted stability of `method` at a step of h frames.
sim::Stability predicted(const sim::Scene &scene, const std::string &method, double h = 1.0);

/// Returns whether energy grows without bound at steps of h frames. Runs from a disturbance of 1e-5 px until
/// the energy has changed by a factor of 1e8 up or down, or for `steps` steps.
bool grows(const OscillatingScene &oscillating, const std::string &method, double h, int steps = 40'000);

/// Returns the smallest step at which energy grows. Searches upwards from `from` in steps of 4 %, then
/// bisects.
double onset(const OscillatingScene &oscillating, const std::string &method, double from);

/// Returns the first remedy of a kind, or null.
const sim::Remedy *findRemedy(const std::vector<sim::Remedy> &all, sim::Remedy::Kind kind);

}
