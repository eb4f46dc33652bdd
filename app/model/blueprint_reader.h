#pragma once

#include "app/model/json_document.h"
#include "lessons/api/step.h"

namespace app {

/// The field "scene" of an experiment for the step `step`.
/// @throws Refusal: wrong types, unknown or missing names, numbers out of range, too much; with the line
sim::Blueprint readBlueprint(const QString &file, const JsonValue &scene, const lessons::Step &step);

}
