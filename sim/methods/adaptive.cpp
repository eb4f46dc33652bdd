#include "sim/methods/adaptive.h"

#include "sim/error.h"
#include "sim/methods/advance.h"

namespace sim {

int Adaptive::order() const
{
    return m_pair.order();
}

void Adaptive::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
    state.stages.setZero(2 * state.points() + state.spin.rows(), Course::columns(m_pair));
    state.resting.setZero(state.points());
    state.ahead = {};
}

std::vector<Phase> Adaptive::phases(const Scene &scene, StepSize size) const
{
    if (const EffectPtr jump = Flow::firstJump(scene, Flow::Contacts::fit))
        throw Error("method-does-not-fit", {{"method", id()}, {"effect", jump->id()}});
    for (const Group &group : scene.groups) {
        if (group.inertia == Inertia::none)
            throw Error("needs-inertia", {{"method", id()}, {"group", group.title}});
    }
    const auto course = std::make_shared<const Course>(scene, m_pair, directions(), size.tolerance);
    Phase phase;
    phase.id = "integrate";
    phase.title = SIM_TEXT("steps of its own");
    phase.points = {0, scene.start.points()};
    phase.moves = true;
    phase.integrates = true;
    phase.within = course->effects();
    phase.regions = {{"sim/methods/advance.cpp", "try_step"},
                     {"sim/methods/advance.cpp", "next_step"},
                     {"sim/methods/advance.cpp", "read_off"},
                     m_shown};
    for (const EffectPtr &effect : phase.within) {
        for (const Region &region : effect->regions(directions()))
            phase.regions.push_back(region);
    }
    phase.run = [course](State &state) { Advance(*course, state).toNextFrame(); };
    phase.runByLaps = [course](State &state, const LapVisit &visit) {
        Advance(*course, state).toNextFrame(visit);
    };
    phase.explain = [](const State &before, const State &after, int point) {
        std::vector<Live> live = changeOf(before, after, point);
        live.push_back({"h", after.ahead.length});
        return live;
    };
    if (scene.groups.empty() || (scene.start.inverseMass == 0.0).all())
        return {};
    return {phase};
}

}
