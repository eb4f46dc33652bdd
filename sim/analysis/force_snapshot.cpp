#include "sim/analysis/force_snapshot.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace sim {

namespace {

void dropIdle(std::vector<ForceSnapshot> &all)
{
    std::erase_if(all, [](const ForceSnapshot &one) { return (one.acceleration == 0.0).all(); });
}

}

std::vector<ForceSnapshot> accumulatedForces(const Track &track)
{
    std::vector<ForceSnapshot> all;
    const Pipeline &pipeline = track.interval().pipeline;
    const DirectionRule directionRule = track.script().method->directionRule();
    const State &state = track.state();
    const int done = track.cursor().phase % pipeline.phasesPerStep();
    for (int i = 0; i < done; ++i) {
        const Phase &phase = pipeline.phaseAt(i);
        if (phase.consumesAcceleration) {
            for (ForceSnapshot &one : all)
                one.acceleration.middleRows(phase.points.first, phase.points.count).setZero();
        }
        const auto *force = as<Force>(phase.effect);
        if (!force)
            continue;
        auto found = std::find_if(all.begin(), all.end(),
                                  [&](const ForceSnapshot &g) { return g.effect == phase.effect; });
        if (found == all.end()) {
            all.push_back({phase.effect, Eigen::ArrayX2d::Zero(state.pointCount(), 2)});
            found = std::prev(all.end());
        }
        // Positions change only when a phase moves, so what was gathered can be found again from where things are.
        force->add(state, phase.points, 1.0, directionRule, found->acceleration);
    }
    dropIdle(all);
    return all;
}

std::vector<ForceSnapshot> currentForces(const Track &track)
{
    std::vector<ForceSnapshot> all;
    const State &state = track.state();
    const DirectionRule directionRule = track.script().method->directionRule();
    for (const EffectPtr &effect : track.interval().scene.effects) {
        const auto *force = as<Force>(effect);
        if (!force)
            continue;
        all.push_back({effect, Eigen::ArrayX2d::Zero(state.pointCount(), 2)});
        force->add(state, {0, state.pointCount()}, 1.0, directionRule, all.back().acceleration);
    }
    dropIdle(all);
    return all;
}

}
