#include "sim/scene/scene.h"

#include <algorithm>

namespace sim {

int Scene::find(const std::string &name) const
{
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

bool Scene::movesByVelocity(int point) const
{
    return std::any_of(groups.begin(), groups.end(), [point](const Group &group) {
        return group.points.contains(point) && group.motion == Motion::byVelocity;
    });
}

}
