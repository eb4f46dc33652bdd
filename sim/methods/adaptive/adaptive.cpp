#include "sim/methods/adaptive/adaptive.h"

#include "sim/base/error.h"
#include "sim/methods/adaptive/island_integrators.h"

namespace sim {

namespace {

std::string firstDrag(const Scene &scene)
{
    for (const EffectPtr &effect : scene.effects) {
        if (as<Drag>(effect))
            return effect->id();
    }
    return {};
}

/// What the equations have in them, and contacts.
std::vector<EffectPtr> effectsWithin(const Flow &flow, const Scene &scene)
{
    std::vector<EffectPtr> all = flow.effects();
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

std::vector<std::string> Adaptive::needs() const
{
    std::vector<std::string> all = m_rule.needs();
    all.insert(all.begin(), "smooth");
    return all;
}

void Adaptive::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
    state.stages.setZero(2 * state.points() + state.spin.rows(), Course::columns(m_rule));
    state.resting.setZero(state.points());
    state.ahead.clear();
}

std::vector<Phase> Adaptive::phases(const Scene &scene, StepSize size) const
{
    if (const EffectPtr jump = Flow::firstJump(scene, Flow::Contacts::fit))
        throw Error("method-does-not-fit", {{"method", id()}, {"effect", jump->id()}});
    for (const Group &group : scene.groups) {
        if (group.inertia == Inertia::none)
            throw Error("needs-inertia", {{"method", id()}, {"group", group.title}});
    }
    const Flow whole(scene, directions());
    if (!m_rule.fits(whole))
        throw Error("method-does-not-fit", {{"method", id()}, {"effect", firstDrag(scene)}});
    Phase phase;
    phase.id = "integrate";
    phase.title = SIM_TEXT("steps of its own");
    phase.points = {0, scene.start.points()};
    phase.moves = true;
    phase.integrates = true;
    phase.within = effectsWithin(whole, scene);
    phase.regions = {{"sim/methods/adaptive/adaptive_stepper.cpp", "try_step"},
                     {"sim/methods/adaptive/adaptive_stepper.cpp", "next_step"},
                     {"sim/methods/adaptive/adaptive_stepper.cpp", "read_off"}};
    phase.regions.insert(phase.regions.end(), m_shown.begin(), m_shown.end());
    for (const EffectPtr &effect : phase.within) {
        for (const Region &region : effect->regions(directions()))
            phase.regions.push_back(region);
    }
    const auto courses = std::make_shared<const Courses>(scene, m_rule, directions(), size.tolerance);
    phase.kernels = {{[courses](State &state) { courses->toNextFrame(state, [] { return true; }); }, {}}};
    phase.runWhile = [courses](State &state, const GoesOn &goesOn) {
        return courses->toNextFrame(state, goesOn);
    };
    phase.runByLaps = [courses](State &state, const LapVisit &visit) {
        courses->toNextFrame(
            state, [] { return true; }, visit);
    };
    phase.explain = [courses](const State &before, const State &after, int point) {
        std::vector<Live> live = changeOf(before, after, point);
        const Course *course = courses->of(point);
        if (course && course->number < after.ahead.size())
            live.push_back({"h", after.ahead[course->number].length});
        return live;
    };
    if (scene.groups.empty() || (scene.start.inverseMass == 0.0).all())
        return {};
    return {phase};
}

}
