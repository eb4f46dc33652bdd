#include "sim/methods/implicit/implicit.h"

#include "sim/base/error.h"

#include <algorithm>

namespace sim {

namespace {

Points everything(const Scene &scene)
{
    return {0, scene.start.points()};
}

/// Whether what a driver does is a phase of its own: the others go with time, and that is in the equations.
bool jumps(const Effect &effect)
{
    const auto *driver = as<Driver>(effect);
    return driver && driver->pace() == Pace::once;
}

/// Whether `effect` can be computed by a method that needs slopes.
bool fits(const Effect &effect, const State &state)
{
    const Points all = {0, state.points()};
    Slopes slopes(state.points());
    if (const auto *force = as<Force>(effect))
        return force->addSlopes(state, all, 1.0, Directions::apart, slopes);
    if (const auto *torque = as<Torque>(effect))
        return torque->addSlopes(state, all, 1.0, slopes);
    if (const auto *drag = as<Drag>(effect)) {
        for (int i = 0; i < state.points(); ++i) {
            if (!drag->rate(i))
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
    phase.regions = effect->regions(Directions::apart);
    return phase;
}

Phase driving(const std::shared_ptr<const Driver> &driver, const Scene &scene, double h)
{
    Phase phase = phaseOf(driver, scene);
    phase.kernels = {{[driver, h](State &state) { driver->drive(state, h); }, {}}};
    phase.explain = [driver](const State &before, const State &after, int point) {
        return driver->explain(before, after, point);
    };
    return phase;
}

Phase touching(const std::shared_ptr<const Contact> &contact, const Scene &scene)
{
    Phase phase = phaseOf(contact, scene);
    phase.kernels = {
        {[contact, all = everything(scene)](State &state) { contact->resolve(state, all); }, {}}};
    phase.explain = changeOf;
    return phase;
}

/// Where a point (or a branch) went, by the names of the shown code.
std::vector<Live> explainSolved(const State &before, const State &after, int point)
{
    if (!after.feels(point))
        return {};
    if (after.spin.rows() > 0)
        return {{"x", after.angle[point], before.angle[point]}, {"v", after.spin[point], before.spin[point]}};
    return {{"x", after.at(point), before.at(point)}, {"v", after.speed(point), before.speed(point)}};
}

}

void Implicit::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
}

void Implicit::checkFit(const Scene &scene) const
{
    for (const EffectPtr &effect : scene.effects) {
        if (effect->count(scene.start, everything(scene)) > 0 && !fits(*effect, scene.start))
            throw Error("method-does-not-fit", {{"method", id()}, {"effect", effect->id()}});
    }
    for (const Group &group : scene.groups) {
        if (group.inertia == Inertia::none)
            throw Error("needs-inertia", {{"method", id()}});
    }
}

Phase Implicit::solving(const Scene &scene, double h) const
{
    Phase phase;
    phase.id = "solve";
    phase.title = SIM_TEXT("solve for the new place");
    phase.points = everything(scene);
    phase.moves = true;
    phase.integrates = true;
    phase.regions = {shown(), {"sim/methods/implicit/newton.cpp", "newton"}};
    const auto equations = std::make_shared<const Equations>(scene, directions());
    for (const EffectPtr &effect : equations->flow().effects()) {
        if (effect->count(scene.start, everything(scene)) == 0)
            continue;
        phase.within.push_back(effect);
        for (const Region &shown : effect->regions(directions())) {
            if (std::find(phase.regions.begin(), phase.regions.end(), shown) == phase.regions.end())
                phase.regions.push_back(shown);
        }
    }
    phase.kernels = {{[take = taking(), equations, h](State &state) {
                          ImplicitStep step(*equations, state);
                          take(step, h);
                          step.finish();
                      },
                      {}}};
    phase.explain = explainSolved;
    return phase;
}

std::vector<Phase> Implicit::phases(const Scene &scene, StepSize size) const
{
    checkFit(scene);
    std::vector<Phase> driversFirst, solve, contacts, driversLast;
    bool leading = true;
    for (const EffectPtr &effect : scene.effects) {
        const auto driver = shared<Driver>(effect);
        leading = leading && driver;
        if (effect->count(scene.start, everything(scene)) == 0)
            continue;
        if (driver && jumps(*driver))
            (leading ? driversFirst : driversLast).push_back(driving(driver, scene, size.h));
        else if (const auto contact = shared<Contact>(effect))
            contacts.push_back(touching(contact, scene));
    }
    Phase whole = solving(scene, size.h);
    bool anyFree = false;
    for (int i = 0; i < scene.start.points(); ++i)
        anyFree = anyFree || (scene.start.feels(i) && scene.hasInertia(i));
    if (anyFree || !whole.within.empty())
        solve.push_back(std::move(whole));
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
