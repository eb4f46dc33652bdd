#pragma once

#include "sim/run/timeline.h"
#include "sim/scenes/creatures.h"

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace support {

/// A scene with named parameters for tests.
struct Sample
{
    std::string name;
    std::function<sim::Scene(const sim::Values &)> build;
    sim::Values values;
};

/// Returns scenes that cover most kinds of effects, handles, different masses and coincident points.
const std::vector<Sample> &samples();
const Sample &sample(const std::string &name);

/// Returns a step of h frames, or for an adaptive method a tolerance of h / 100 px.
sim::StepSize stepFor(const sim::Method &method, double h);
/// Returns the methods with a fixed step.
std::vector<sim::MethodPtr> fixedMethods();
/// Returns whether `method` can compute `scene`.
bool fits(const sim::Scene &scene, const sim::Method &method);

/// Returns a script for `sample` with a step as from stepFor().
sim::Script script(const Sample &sample, const std::string &method, double h = 1.0);
/// Returns a script for a scene without parameters.
sim::Script script(const sim::Scene &scene, const std::string &method, double h = 1.0);

/// Places every point at random in a square of `side` px around (270, 200).
void scatter(sim::State &state, std::uint64_t seed, double side);

/// Returns the state after `frames` frames. Runs the phases one after the other, without a Track.
sim::State plainRun(const sim::Scene &scene, const std::string &method, double h, int frames);

/// Returns the solution of x'' = -k x - c x' with c = -ln(damp) from its two roots, which may be complex.
double dampedOscillation(double x0, double v0, double k, double damp, double t);

/// A generator of random numbers that are the same on every machine.
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : m_engine(seed) {}
    /// Returns a number in [low, high).
    double real(double low, double high);
    /// Returns a whole number from low to high, both included.
    int whole(int low, int high);
    /// Returns true with probability `share`.
    bool chance(double share) { return real(0.0, 1.0) < share; }

private:
    std::mt19937_64 m_engine;
};

/// Seeks `cursors` random cursors in the first `frames` frames and compares each state with a straight run.
/// Returns the first difference, or an empty string.
std::string seekMismatch(const sim::Script &script, std::size_t budget, int frames, int cursors,
                         std::uint64_t seed);

/// Returns a description of the first difference between two states, or an empty string.
std::string difference(const sim::State &a, const sim::State &b);

}
