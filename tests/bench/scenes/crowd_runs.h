#pragma once

#include "tests/bench/scenes/crowd.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>

namespace bench::crowd {

/// A program that computes the creatures of a scene of crowd.h, frame by frame.
class Runner
{
public:
    virtual ~Runner() = default;
    /// Puts all points back to their start positions, at rest.
    virtual void restart() = 0;
    virtual void frame() = 0;
    /// Returns the position of a point of a creature, px; foot -1 is the body.
    virtual sim::Vec2 at(int creature, int foot) const = 0;
};

struct Entry
{
    std::string name;              ///< of the benchmark
    sim::Scene (*scene)(int) = {}; ///< returns the scene for a number of creatures
    std::function<std::unique_ptr<Runner>(const sim::Scene &scene, int creatures)> make;
    /// The allowed mean distance of its points from our pipeline's after 20 frames, px. 1e-9 for the same
    /// sums in another order, more for another integration method.
    double apart = 1e-9;
    std::string needs = {}; ///< why it cannot run on this machine; empty if it can
};

/// Adds benchmarks of a frame of 100, 1,000 and 10,000 creatures, in runs of `frames` frames from the start.
benchmark::internal::Benchmark *enter(Entry entry);

/// Returns the runner of the app: the scene's pipeline with semi-implicit Euler.
std::unique_ptr<Runner> ours(const sim::Scene &scene, int creatures);

}
