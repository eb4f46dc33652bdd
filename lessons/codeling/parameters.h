#pragma once

#include "lessons/api/parameter.h"

#include <vector>

/// The parameters of this lesson, in the groups in which the steps bring them.
namespace codeling {

/// keep, k, dt and the target.
std::vector<lessons::Parameter> motorParameters();
lessons::Parameter restLength();
lessons::Parameter anticipationPart();
/// along, across, soft, hard, min_length and max_length.
std::vector<lessons::Parameter> spineParameters();
/// tentacles, links and water.
std::vector<lessons::Parameter> tentacleParameters();

}
