#pragma once

#include "lessons/api/parameter.h"

#include <vector>

namespace sandbox {

/// The numbers of everything that can act on a whole scene, each with the effects that read it.
std::vector<lessons::Parameter> sceneParameters();

}
