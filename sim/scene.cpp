#include "sim/scene.h"

#include <algorithm>

namespace sim {

int Scene::find(const std::string &name) const
{
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

}
