#include "sim/analysis/force_snapshot.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace sim {

namespace {

void dropIdle(std::vector<Gathered> &all)
{
    std::erase_if(all, [](const Gathered &one) { return (one.acceleration == 0.0).all(); });
}

}

std::vector<Gathered> gathered(const Track &track)
{
    std::vector<Gathered> all;
    const Pipeline &pipeline = track.shown().pipeline;
    const Directions directions = track.script().method->directions();
    const State &state = track.now();
    const int done = track.at().phase % pipeline.phasesPerStep();
    for (int i = 0; i < done; ++i) {
        const Phase &phase = pipeline.phaseAt(i);
        if (phase.moves) {
            for (Gathered &one : all)
                one.acceleration.middleRows(phase.points.first, phase.points.count).setZero();
        }
        const auto *force = as<Force>(phase.effect);
        if (!force)
            continue;
        auto found =
            std::find_if(all.begin(), all.end(), [&](const Gathered &g) { return g.effect == phase.effect; });
        if (found == all.end()) {
            all.push_back({phase.effect, Eigen::ArrayX2d::Zero(state.points(), 2)});
            found = std::prev(all.end());
        }
        // Positions change only when a phase moves, so what was gathered can be found again from where things are.
        force->add(state, phase.points, 1.0, directions, found->acceleration);
    }
    dropIdle(all);
    return all;
}

std::vector<Gathered> pullsNow(const Track &track)
{
    std::vector<Gathered> all;
    const State &state = track.now();
    const Directions directions = track.script().method->directions();
    for (const EffectPtr &effect : track.shown().scene.effects) {
        const auto *force = as<Force>(effect);
        if (!force)
            continue;
        all.push_back({effect, Eigen::ArrayX2d::Zero(state.points(), 2)});
        force->add(state, {0, state.points()}, 1.0, directions, all.back().acceleration);
    }
    dropIdle(all);
    return all;
}

}
