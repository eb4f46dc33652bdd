#include "lessons/api/view/named_place.h"

#include "lessons/api/view/acting.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/scene/values.h"

namespace lessons {

std::optional<sim::Vec2> placeNamed(const QString &name, const sim::Scene &scene, const sim::State &state,
                                    const sim::Values &values)
{
    if (const int point = scene.find(name.toStdString()); point >= 0)
        return state.positionOf(point);
    if (name == u"pointer")
        return state.input.pointer;
    if (name == u"target" && values.has("target_x"))
        return state.input.target;
    if (name != u"centre")
        return std::nullopt;
    if (const auto *spring = effectOf<sim::PointSpring>(scene))
        return spring->centre();
    if (values.has("centre_x") && values.has("centre_y")) // a spring that does not act yet
        return sim::Vec2{values["centre_x"], values["centre_y"]};
    return std::nullopt;
}

}
