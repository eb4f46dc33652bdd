#pragma once

#include "app/model/experiment/json_document.h"
#include "lessons/api/step.h"

namespace app {

/// Reads the field "scene" of an experiment for `step`.
/// @throws UserError: wrong types, unknown or missing names, numbers out of range, too many entries; with the line
sim::Blueprint readBlueprint(const QString &file, const JsonValue &scene, const lessons::Step &step);

}
