#include "lessons/api/blueprint_of.h"

#include "lessons/api/view/view.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/scene.h"

namespace lessons {

std::optional<sim::BlueprintDraft> blueprintOf(const sim::Scene &scene, const sim::State &now,
                                               const View &look)
{
    if (now.angle.rows() > 0)
        return {};
    sim::BlueprintDraft draft;
    draft.state = now;
    for (int i = 0; i < now.pointCount(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double inverse = scene.start.inverseMass[i];
        sim::BlueprintPoint point{scene.names[at], now.positionOf(i), now.velocityOf(i)};
        point.mass = inverse == 0.0 ? 1.0 : 1.0 / inverse;
        point.fixed = inverse == 0.0;
        if (look.bodies[at].shape != BodyView::Shape::none) // else it keeps the usual size
            point.size = 2.0 * look.bodies[at].radius;
        draft.blueprint.points.push_back(point);
    }
    for (const sim::EffectPtr &effect : scene.effects) {
        if (!effect->addToDraft(draft))
            draft.omit(effect->title());
    }
    return draft;
}

}
