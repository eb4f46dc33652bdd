#pragma once

#include "sim/run/timeline.h"
#include "sim/scenes/creatures.h"

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace support {

/// A scene to test with.
struct Sample
{
    std::string name;
    std::function<sim::Scene(const sim::Values &)> build;
    sim::Values values;
};

/// Scenes that between them have every effect, handles, several masses and points in one place.
const std::vector<Sample> &samples();
const Sample &sample(const std::string &name);

/// The step that `method` takes here: h, or for an adaptive one a tolerance of a hundredth of h in px.
sim::StepSize stepFor(const sim::Method &method, double h);
/// The methods whose steps have a length.
std::vector<sim::MethodPtr> fixedMethods();
/// Whether `method` can compute `scene`.
bool fits(const sim::Scene &scene, const sim::Method &method);

sim::Script script(const Sample &sample, const std::string &method, double h = 1.0);
/// A script for a scene that has no parameters.
sim::Script script(const sim::Scene &scene, const std::string &method, double h = 1.0);

/// Puts every point somewhere in a square of `side` px around (270, 200).
void scatter(sim::State &state, std::uint64_t seed, double side);

/// The state after `frames` frames, computed without a Track: nothing but the phases, one after the other.
sim::State plainRun(const sim::Scene &scene, const std::string &method, double h, int frames);

/// Numbers for a test, the same on every machine.
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : m_engine(seed) {}
    double real(double low, double high);
    /// Both ends included.
    int whole(int low, int high);
    bool chance(double share) { return real(0.0, 1.0) < share; }

private:
    std::mt19937_64 m_engine;
};

/// Seeks `cursors` random cursors of the first `frames` frames and compares each with a straight run. Returns
/// what differs first, or nothing.
std::string seekMismatch(const sim::Script &script, std::size_t budget, int frames, int cursors,
                         std::uint64_t seed);

/// The place of the first difference between two states, for a message; empty when there is none.
std::string difference(const sim::State &a, const sim::State &b);

}
