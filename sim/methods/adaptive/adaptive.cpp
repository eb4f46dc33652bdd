#include "sim/methods/adaptive/adaptive.h"

#include "sim/base/error.h"
#include "sim/methods/adaptive/island_integrators.h"
#include "sim/methods/zero_accelerations.h"

namespace sim {

namespace {

/// Returns the id of the first drag in `scene`.
std::string firstDrag(const Scene &scene)
{
    for (const EffectPtr &effect : scene.effects) {
        if (as<Drag>(effect))
            return effect->id();
    }
    return {};
}

/// Returns the id of the effect for which a step rule does not fit the equations: a force that depends on velocities, or
/// else the first drag.
std::string misfitOf(const OdeSystem &system, const Scene &scene)
{
    const EffectPtr force = system.firstVelocityForce();
    return force && system.uniformRate() ? force->id() : firstDrag(scene);
}

/// Returns the effects of the equations, and contacts.
std::vector<EffectPtr> innerEffectsOf(const OdeSystem &system, const Scene &scene)
{
    std::vector<EffectPtr> all = system.effects();
    for (const EffectPtr &effect : scene.effects) {
        if (as<Contact>(effect))
            all.push_back(effect);
    }
    return all;
}

}

int Adaptive::order() const
{
    return m_rule.order();
}

std::vector<std::string> Adaptive::requirements() const
{
    std::vector<std::string> all = m_rule.requirements();
    all.insert(all.begin(), "smooth");
    return all;
}

void Adaptive::prepareState(State &state) const
{
    zeroAccelerations(state);
    state.stages.setZero(2 * state.pointCount() + state.spin.rows(), IslandIntegrator::columns(m_rule));
    state.restingContacts.setZero(state.pointCount());
    state.adaptiveSteps.clear();
}

std::vector<Phase> Adaptive::phases(const Scene &scene, StepSize size) const
{
    if (const EffectPtr discontinuity = OdeSystem::firstDiscontinuity(scene, OdeSystem::Contacts::allowed))
        throw Error("method-does-not-fit", {{"method", id()}, {"effect", discontinuity->id()}});
    for (const Group &group : scene.groups) {
        if (group.motion == Motion::prescribed)
            throw Error("needs-inertia", {{"method", id()}, {"group", group.title}});
    }
    const OdeSystem system(scene, directionRule());
    if (!m_rule.fits(system))
        throw Error("method-does-not-fit", {{"method", id()}, {"effect", misfitOf(system, scene)}});
    Phase phase;
    phase.id = "integrate";
    phase.title = SIM_TEXT("adaptive steps");
    phase.points = {0, scene.start.pointCount()};
    phase.consumesAcceleration = true;
    phase.integrates = true;
    phase.innerEffects = innerEffectsOf(system, scene);
    phase.regions = {{"sim/methods/adaptive/adaptive_stepper.cpp", "try_step"},
                     {"sim/methods/adaptive/adaptive_stepper.cpp", "next_step"},
                     {"sim/methods/adaptive/adaptive_stepper.cpp", "read_off"}};
    phase.regions.insert(phase.regions.end(), m_shown.begin(), m_shown.end());
    for (const EffectPtr &effect : phase.innerEffects) {
        for (const Region &region : effect->regions(directionRule()))
            phase.regions.push_back(region);
    }
    const auto integrators =
        std::make_shared<const IslandIntegrators>(scene, m_rule, directionRule(), size.tolerance);
    phase.kernels = {
        {[integrators](State &state) { integrators->toNextFrame(state, [] { return true; }); }, {}}};
    phase.runInterruptible = [integrators](State &state, const ShouldContinue &shouldContinue) {
        return integrators->toNextFrame(state, shouldContinue);
    };
    phase.runWithDenseOutput = [integrators](State &state, const SegmentVisitor &visit) {
        integrators->toNextFrame(
            state, [] { return true; }, visit);
    };
    phase.explain = [integrators](const State &before, const State &after, int point) {
        std::vector<LiveValue> live = motionChange(before, after, point);
        const IslandIntegrator *integrator = integrators->of(point);
        if (integrator && integrator->islandIndex < after.adaptiveSteps.size())
            live.push_back({"h", after.adaptiveSteps[integrator->islandIndex].length});
        return live;
    };
    if (scene.groups.empty() || (scene.start.inverseMass == 0.0).all())
        return {};
    return {phase};
}

}
