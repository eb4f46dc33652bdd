#include "sim/methods/implicit/implicit.h"

#include "sim/base/error.h"
#include "sim/methods/zero_accelerations.h"
#include "sim/pipeline/phase_builder.h"

#include <algorithm>
#include <utility>

namespace sim {

namespace {

PointRange everything(const Scene &scene)
{
    return {0, scene.start.pointCount()};
}

/// Returns whether an implicit method can compute `effect`: a force or torque needs a Jacobian, a drag a
/// rate.
bool fits(const Effect &effect, const State &state)
{
    const PointRange all = {0, state.pointCount()};
    Jacobian jacobian(state.pointCount());
    if (const auto *force = as<Force>(effect))
        return force->addJacobian(state, all, 1.0, DirectionRule::regularised, jacobian);
    if (const auto *torque = as<Torque>(effect))
        return torque->addJacobian(state, all, 1.0, jacobian);
    if (const auto *drag = as<Drag>(effect))
        return hasDampingRate(*drag, all);
    return as<Driver>(effect) || as<Contact>(effect);
}

/// Explains the motion of a point, or of a branch if points have spins, with the variable names of the shown
/// code.
std::vector<LiveValue> explainSolved(const State &before, const State &after, int point)
{
    if (!after.isDynamic(point))
        return {};
    if (after.spin.rows() > 0)
        return {{"x", after.angle[point], before.angle[point]}, {"v", after.spin[point], before.spin[point]}};
    return {{"x", after.positionOf(point), before.positionOf(point)},
            {"v", after.velocityOf(point), before.velocityOf(point)}};
}

}

void ImplicitMethod::prepareState(State &state) const
{
    zeroAccelerations(state);
}

void ImplicitMethod::checkFit(const Scene &scene) const
{
    for (const EffectPtr &effect : scene.effects) {
        if (effect->count(scene.start, everything(scene)) > 0 && !fits(*effect, scene.start))
            throw Error("method-does-not-fit", {{"method", id()}, {"effect", effect->id()}});
    }
    for (const Group &group : scene.groups) {
        if (group.motion == Motion::prescribed)
            throw Error("needs-inertia", {{"method", id()}});
    }
}

Phase ImplicitMethod::solvePhase(const Scene &scene, double h) const
{
    Phase phase;
    phase.id = "solve";
    phase.title = SIM_TEXT("solve for new positions");
    phase.points = everything(scene);
    phase.consumesAcceleration = true;
    phase.integrates = true;
    phase.regions = {stepRegion(), {"sim/methods/implicit/newton.cpp", "newton"}};
    const auto equations = std::make_shared<const Equations>(scene, directionRule());
    for (const EffectPtr &effect : equations->system().effects()) {
        if (effect->count(scene.start, everything(scene)) == 0)
            continue;
        phase.innerEffects.push_back(effect);
        for (const Region &region : effect->regions(directionRule())) {
            if (std::find(phase.regions.begin(), phase.regions.end(), region) == phase.regions.end())
                phase.regions.push_back(region);
        }
    }
    phase.kernels = {{[advance = stepFunction(), equations, h](State &state) {
                          ImplicitStep step(*equations, state);
                          advance(step, h);
                          step.finish();
                      },
                      {}}};
    phase.explain = explainSolved;
    return phase;
}

std::vector<Phase> ImplicitMethod::phases(const Scene &scene, StepSize size) const
{
    checkFit(scene);
    PhaseBuilder step(scene, directionRule(), size.h);
    Phase solve = solvePhase(scene, size.h);
    const bool anyChange = step.anyMoves() || !solve.innerEffects.empty();
    //! [implicit_order]
    PhasePoints all = step.allPoints();
    step.leadingImpulses();
    // all forces, damping and motion
    if (anyChange)
        step.add(std::move(solve));
    step.contacts(all);
    step.trailingImpulses();
    //! [implicit_order]
    return step.take();
}

}
