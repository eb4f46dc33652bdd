#pragma once

#include "sim/pipeline/pipeline.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

namespace sim {

/// A part of a run in which no parameter changes, with its composed scene.
struct ComposedInterval
{
    Values values;
    Scene scene;
    Pipeline pipeline;
};

}
