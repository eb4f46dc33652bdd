#include "sim/methods/implicit/implicit.h"

#include "sim/base/error.h"
#include "sim/methods/zero_accelerations.h"

#include <algorithm>

namespace sim {

namespace {

PointRange everything(const Scene &scene)
{
    return {0, scene.start.pointCount()};
}

/// Returns whether `effect` is a driver that needs a separate phase. The equations include all other drivers.
bool isImpulsiveDriver(const Effect &effect)
{
    const auto *driver = as<Driver>(effect);
    return driver && driver->timing() == DriverTiming::impulsive;
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
    if (const auto *drag = as<Drag>(effect)) {
        for (int i = 0; i < state.pointCount(); ++i) {
            if (!drag->dampingRate(i))
                return false;
        }
        return true;
    }
    return as<Driver>(effect) || as<Contact>(effect);
}

Phase phaseOf(const EffectPtr &effect, const Scene &scene)
{
    Phase phase;
    phase.id = effect->id();
    phase.title = effect->title();
    phase.kind = effect->kind();
    phase.effect = effect;
    phase.points = everything(scene);
    phase.regions = effect->regions(DirectionRule::regularised);
    return phase;
}

Phase driverPhase(const std::shared_ptr<const Driver> &driver, const Scene &scene, double h)
{
    Phase phase = phaseOf(driver, scene);
    phase.kernels = {{[driver, h](State &state) { driver->drive(state, h); }, {}}};
    phase.explain = [driver](const State &before, const State &after, int point) {
        return driver->explain(before, after, point);
    };
    return phase;
}

Phase contactPhase(const std::shared_ptr<const Contact> &contact, const Scene &scene)
{
    Phase phase = phaseOf(contact, scene);
    phase.kernels = {
        {[contact, all = everything(scene)](State &state) { contact->resolve(state, all); }, {}}};
    phase.explain = motionChange;
    return phase;
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
    std::vector<Phase> driversFirst, solve, contacts, driversLast;
    bool leading = true;
    for (const EffectPtr &effect : scene.effects) {
        const auto driver = sharedAs<Driver>(effect);
        leading = leading && driver;
        if (effect->count(scene.start, everything(scene)) == 0)
            continue;
        if (driver && isImpulsiveDriver(*driver))
            (leading ? driversFirst : driversLast).push_back(driverPhase(driver, scene, size.h));
        else if (const auto contact = sharedAs<Contact>(effect))
            contacts.push_back(contactPhase(contact, scene));
    }
    Phase solvePhase = this->solvePhase(scene, size.h);
    bool anyMoves = false;
    for (int i = 0; i < scene.start.pointCount(); ++i)
        anyMoves = anyMoves || (scene.start.isDynamic(i) && scene.movesByVelocity(i));
    if (anyMoves || !solvePhase.innerEffects.empty())
        solve.push_back(std::move(solvePhase));
    std::vector<Phase> phases;
    const auto add = [&phases](const std::vector<Phase> &more) {
        phases.insert(phases.end(), more.begin(), more.end());
    };
    //! [implicit_order]
    add(driversFirst);
    // all forces, damping and motion
    add(solve);
    add(contacts);
    add(driversLast);
    //! [implicit_order]
    return phases;
}

}
