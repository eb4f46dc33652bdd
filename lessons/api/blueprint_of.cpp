#include "lessons/api/blueprint_of.h"

#include "lessons/api/view/scene_view.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/scene.h"

namespace lessons {

std::optional<sim::Taken> blueprintOf(const sim::Scene &scene, const sim::State &now, const Look &look)
{
    if (now.angle.rows() > 0)
        return {};
    sim::Taken taken;
    taken.now = now;
    for (int i = 0; i < now.points(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double inverse = scene.start.inverseMass[i];
        sim::BuiltPoint point{scene.names[at], now.at(i), now.speed(i)};
        point.mass = inverse == 0.0 ? 1.0 : 1.0 / inverse;
        point.fixed = inverse == 0.0;
        if (look.bodies[at].shape != BodyLook::Shape::none) // else it keeps the usual size
            point.size = 2.0 * look.bodies[at].radius;
        taken.blueprint.points.push_back(point);
    }
    for (const sim::EffectPtr &effect : scene.effects) {
        if (!effect->takeInto(taken))
            taken.leave(effect->title());
    }
    return taken;
}

}
