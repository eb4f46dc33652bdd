#pragma once

#include "sim/pipeline/pipeline.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

namespace sim {

/// A stretch of a run in which no parameter changes: the scene, composed.
struct ComposedInterval
{
    Values values;
    Scene scene;
    Pipeline pipeline;
};

}
