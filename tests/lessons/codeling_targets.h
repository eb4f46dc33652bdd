#pragma once

#include "sim/run/script/script.h"

#include <random>
#include <utility>
#include <vector>

namespace support {

using Targets = std::vector<std::pair<std::int64_t, sim::Vec2>>;

/// Clicks at random places on the stage, `least` to `most` frames apart.
inline Targets randomTargets(int frames, int least, int most, unsigned seed)
{
    std::mt19937 random(seed);
    Targets targets;
    for (std::int64_t frame = 5; frame < frames;
         frame += std::uniform_int_distribution<int>(least, most)(random)) {
        const double x = std::uniform_real_distribution<double>(0, 540)(random);
        targets.push_back({frame, {x, std::uniform_real_distribution<double>(0, 400)(random)}});
    }
    return targets;
}

inline void send(sim::Script &script, const Targets &targets)
{
    for (const auto &[frame, at] : targets)
        script.input.push_back({frame, sim::Target{at}});
}

}
