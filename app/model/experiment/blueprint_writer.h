#pragma once

#include "sim/scene/blueprint.h"

namespace app {

class JsonWriter;

/// Writes the value of the field "scene" of an experiment: an object whose lists have one entry per line. Default
/// values are omitted.
void writeBlueprint(const sim::Blueprint &plan, JsonWriter &json);

}
