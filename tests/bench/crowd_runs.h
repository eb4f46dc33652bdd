#pragma once

#include "crowd.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>

namespace bench::crowd {

/// Who computes the creatures of a scene of crowd.h, frame by frame.
class Runner
{
public:
    virtual ~Runner() = default;
    /// Puts all back to where they started, at rest.
    virtual void restart() = 0;
    virtual void frame() = 0;
    /// Where a point of a creature is, px; foot -1 is the body.
    virtual sim::Vec2 at(int creature, int foot) const = 0;
};

struct Entry
{
    std::string name;              ///< of the benchmark
    sim::Scene (*scene)(int) = {}; ///< of so many creatures
    std::function<std::unique_ptr<Runner>(const sim::Scene &scene, int creatures)> make;
    /// How far, in px, its points may be on the average from those of our pipeline after 20 frames: 1e-9 for the same sums
    /// in another order, more for who has another way to take a step.
    double apart = 1e-9;
    std::string needs = {}; ///< why it cannot run on this machine; empty where it can
};

/// Adds a benchmark: a frame of 100, 1,000 and 10,000 creatures, in runs of `frames` frames from the start.
benchmark::internal::Benchmark *enter(Entry entry);

/// What the app runs: the scene's pipeline under semi-implicit Euler.
std::unique_ptr<Runner> ours(const sim::Scene &scene, int creatures);

}
