#pragma once

#include "sim/scene/blueprint.h"

#include <QString>

namespace app {

/// The value of the field "scene" of an experiment: an object whose lists have one entry a line. What is as usual is
/// left out.
QString blueprintText(const sim::Blueprint &plan);

}
