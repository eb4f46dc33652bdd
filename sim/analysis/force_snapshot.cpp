#include "sim/analysis/force_snapshot.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace sim {

namespace {

void removeZeroForces(std::vector<ForceSnapshot> &snapshots)
{
    std::erase_if(snapshots,
                  [](const ForceSnapshot &snapshot) { return (snapshot.acceleration == 0.0).all(); });
}

}

std::vector<ForceSnapshot> accumulatedForces(const Track &track)
{
    std::vector<ForceSnapshot> snapshots;
    const Pipeline &pipeline = track.interval().pipeline;
    const DirectionRule directionRule = track.script().method->directionRule();
    const State &state = track.state();
    const int phasesDone = track.cursor().phase % pipeline.phasesPerStep();
    for (int i = 0; i < phasesDone; ++i) {
        const Phase &phase = pipeline.phaseAt(i);
        if (phase.consumesAcceleration) {
            for (ForceSnapshot &snapshot : snapshots)
                snapshot.acceleration.middleRows(phase.points.first, phase.points.count).setZero();
        }
        const auto *force = as<Force>(phase.effect);
        if (!force)
            continue;
        auto found = std::find_if(snapshots.begin(), snapshots.end(), [&](const ForceSnapshot &snapshot) {
            return snapshot.effect == phase.effect;
        });
        if (found == snapshots.end()) {
            snapshots.push_back({phase.effect, Eigen::ArrayX2d::Zero(state.pointCount(), 2)});
            found = std::prev(snapshots.end());
        }
        // No point moves between a force phase and the phase that consumes its acceleration. So the current
        // positions still give the acceleration that was added.
        force->add(state, phase.points, 1.0, directionRule, found->acceleration);
    }
    removeZeroForces(snapshots);
    return snapshots;
}

std::vector<ForceSnapshot> currentForces(const Track &track)
{
    std::vector<ForceSnapshot> snapshots;
    const State &state = track.state();
    const DirectionRule directionRule = track.script().method->directionRule();
    for (const EffectPtr &effect : track.interval().scene.effects) {
        const auto *force = as<Force>(effect);
        if (!force)
            continue;
        snapshots.push_back({effect, Eigen::ArrayX2d::Zero(state.pointCount(), 2)});
        force->add(state, {0, state.pointCount()}, 1.0, directionRule, snapshots.back().acceleration);
    }
    removeZeroForces(snapshots);
    return snapshots;
}

}
