#pragma once

#include "sim/run/script/script.h"

#include <random>
#include <utility>
#include <vector>

namespace support {

using Targets = std::vector<std::pair<std::int64_t, sim::Vec2>>;

/// Returns clicks at random positions on the stage, from `minFrames` to `maxFrames` frames after one another.
inline Targets randomTargets(int frames, int minFrames, int maxFrames, unsigned seed)
{
    std::mt19937 random(seed);
    Targets targets;
    for (std::int64_t frame = 5; frame < frames;
         frame += std::uniform_int_distribution<int>(minFrames, maxFrames)(random)) {
        const double x = std::uniform_real_distribution<double>(0, 540)(random);
        targets.push_back({frame, {x, std::uniform_real_distribution<double>(0, 400)(random)}});
    }
    return targets;
}

/// Adds `targets` to the input of `script`.
inline void addTargets(sim::Script &script, const Targets &targets)
{
    for (const auto &[frame, position] : targets)
        script.input.push_back({frame, sim::Target{position}});
}

}
