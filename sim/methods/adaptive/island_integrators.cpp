#include "sim/methods/adaptive/island_integrators.h"

#include "sim/scene/islands.h"

#include <algorithm>

namespace sim {

namespace {

/// Drivers run one clock for all, and place things after everything else. Where things turn, drivers do that.
bool isOneIsland(const Scene &scene)
{
    const auto drives = [&](const EffectPtr &effect) {
        return as<Driver>(effect) && effect->count(scene.start, {0, scene.start.pointCount()}) > 0;
    };
    return scene.start.spin.rows() > 0 || std::any_of(scene.effects.begin(), scene.effects.end(), drives);
}

std::vector<std::vector<PointRange>> partsOf(const Scene &scene)
{
    if (isOneIsland(scene))
        return {{{0, scene.start.pointCount()}}};
    return islandsOf(scene);
}

/// Whether any of its points can move, held or not.
bool canMove(const Scene &scene, const std::vector<PointRange> &ranges)
{
    for (const PointRange &range : ranges) {
        for (int point = range.first; point < range.end(); ++point) {
            if (scene.start.isDynamic(point) && scene.movesByVelocity(point))
                return true;
        }
    }
    return false;
}

}

IslandIntegrators::IslandIntegrators(const Scene &scene, const StepRule &rule, DirectionRule directionRule,
                                     double tolerance)
{
    Eigen::Index column = 0;
    for (std::vector<PointRange> &ranges : partsOf(scene)) {
        if (!canMove(scene, ranges))
            continue;
        IslandIntegrator &integrator = m_integrators.emplace_back(
            scene, OdeSystem(scene, directionRule, std::move(ranges)), rule, tolerance);
        integrator.islandIndex = m_integrators.size() - 1;
        integrator.column = column;
        column += static_cast<Eigen::Index>(integrator.system.size()) * IslandIntegrator::columns(rule);
    }
}

template <class One>
bool IslandIntegrators::each(State &state, One &&advance) const
{
    state.adaptiveSteps.resize(m_integrators.size());
    for (const IslandIntegrator &integrator : m_integrators) {
        if (!advance(integrator))
            return false;
        if (state.adaptiveSteps[integrator.islandIndex].stuckPoint >= 0)
            return true;
    }
    return true;
}

bool IslandIntegrators::toNextFrame(State &state, const ShouldContinue &shouldContinue) const
{
    StepBudget budget(shouldContinue, state.pointCount());
    return each(state, [&](const IslandIntegrator &integrator) {
        return AdaptiveStepper(integrator, state).toNextFrame(budget);
    });
}

bool IslandIntegrators::toNextFrame(State &state, const ShouldContinue &shouldContinue,
                                    const SegmentVisitor &visit) const
{
    StepBudget budget(shouldContinue, state.pointCount());
    return each(state, [&](const IslandIntegrator &integrator) {
        return AdaptiveStepper(integrator, state).toNextFrame(budget, visit);
    });
}

const IslandIntegrator *IslandIntegrators::of(int point) const
{
    for (const IslandIntegrator &integrator : m_integrators) {
        for (const PointRange &range : integrator.system.ranges()) {
            if (range.contains(point))
                return &integrator;
        }
    }
    return nullptr;
}

}
