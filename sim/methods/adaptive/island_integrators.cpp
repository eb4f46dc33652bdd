#include "sim/methods/adaptive/island_integrators.h"

#include "sim/scene/islands.h"

#include <algorithm>

namespace sim {

namespace {

/// Returns whether the whole scene needs common steps: with drivers, which have one clock for all points, or
/// with spins, because a driver computes the positions of points that turn.
bool needsCommonSteps(const Scene &scene)
{
    const auto drives = [&](const EffectPtr &effect) {
        return as<Driver>(effect) && effect->count(scene.start, {0, scene.start.pointCount()}) > 0;
    };
    return scene.start.spin.rows() > 0 || std::any_of(scene.effects.begin(), scene.effects.end(), drives);
}

/// Returns the points that one integrator advances together.
std::vector<std::vector<PointRange>> integratedIslands(const Scene &scene)
{
    if (needsCommonSteps(scene))
        return {{{0, scene.start.pointCount()}}};
    return islandsOf(scene);
}

/// Returns whether any of the points can move when it is not dragged.
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
    for (std::vector<PointRange> &ranges : integratedIslands(scene)) {
        if (!canMove(scene, ranges))
            continue;
        IslandIntegrator &integrator = m_integrators.emplace_back(
            scene, OdeSystem(scene, directionRule, std::move(ranges)), rule, tolerance);
        integrator.islandIndex = m_integrators.size() - 1;
        integrator.column = column;
        column += static_cast<Eigen::Index>(integrator.system.size()) * IslandIntegrator::columns(rule);
    }
}

template <class Advance>
bool IslandIntegrators::forEachIsland(State &state, Advance &&advance) const
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
    return forEachIsland(state, [&](const IslandIntegrator &integrator) {
        return AdaptiveStepper(integrator, state).toNextFrame(budget);
    });
}

bool IslandIntegrators::toNextFrame(State &state, const ShouldContinue &shouldContinue,
                                    const SegmentVisitor &visit) const
{
    StepBudget budget(shouldContinue, state.pointCount());
    return forEachIsland(state, [&](const IslandIntegrator &integrator) {
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
