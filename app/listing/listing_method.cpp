#include "app/listing/listing_method.h"

#include "sim/base/error.h"

#include <sstream>

namespace listing {

void ListingMethod::prepareState(sim::State &state) const
{
    state.acceleration.resize(0, 2);
    state.angularAcceleration.resize(0);
    state.memory.clear(); // the first frame begins with the initial values
}

std::vector<sim::Phase> ListingMethod::phases(const sim::Scene &scene, sim::StepSize step) const
{
    if (step.h != 1.0) {
        std::ostringstream text;
        text << step.h;
        throw sim::Error("listing-needs-frame-steps", {{"h", text.str()}});
    }
    sim::Phase phase;
    phase.effect = std::make_shared<ListingEffect>(m_program->dependsOnTime());
    phase.id = phase.effect->id();
    phase.title = phase.effect->title();
    phase.kind = phase.effect->kind();
    phase.innerEffects = scene.effects;
    phase.points = {0, scene.start.pointCount()};
    phase.explain = sim::motionChange;
    auto binding = std::make_shared<const Binding>(bind(m_program->vocabulary(), scene));
    const auto frame = [program = m_program, binding](sim::State &state) {
        if (program->run(state, *binding))
            state.stepFailed = true;
    };
    phase.kernels = {{frame, {}, {}}};
    return {phase};
}

}
