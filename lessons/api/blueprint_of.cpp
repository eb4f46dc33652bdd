#include "lessons/api/blueprint_of.h"

#include "lessons/api/view/view.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/scene.h"

namespace lessons {

std::optional<sim::BlueprintDraft> blueprintOf(const sim::Scene &scene, const sim::State &state,
                                               const View &view)
{
    if (state.angle.rows() > 0)
        return {};
    sim::BlueprintDraft draft;
    draft.state = state;
    for (int i = 0; i < state.pointCount(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const double inverseMass = scene.start.inverseMass[i];
        sim::BlueprintPoint point{scene.names[index], state.positionOf(i), state.velocityOf(i)};
        point.mass = inverseMass == 0.0 ? 1.0 : 1.0 / inverseMass;
        point.fixed = inverseMass == 0.0;
        if (view.bodies[index].shape != BodyView::Shape::none) // otherwise the default size stays
            point.size = 2.0 * view.bodies[index].radius;
        draft.blueprint.points.push_back(point);
    }
    for (const sim::EffectPtr &effect : scene.effects) {
        if (!effect->addToDraft(draft))
            draft.omit(effect->title());
    }
    return draft;
}

}
