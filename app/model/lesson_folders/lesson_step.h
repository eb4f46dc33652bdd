#pragma once

#include "app/model/experiment/experiment.h"
#include "app/model/lesson_folders/lesson_parameters.h"
#include "lessons/api/step.h"
#include "lessons/api/text/document.h"

namespace app {

/// Returns a step without texts whose run is that of `scene`, an experiment with the step `base`: its scene, parameters,
/// method and input are what the step begins with. It has the parameters `declared`, too, of which `targets` says what they
/// set in the scene.
lessons::Step stepOf(const QString &id, const lessons::Step &base, const Experiment &scene,
                     const std::vector<lessons::Parameter> &declared,
                     const std::vector<ParameterTarget> &targets);

/// Returns the tests of the things to try of `document`, from its conditions. `step` has their scene.
/// @throws lessons::DocumentError: a thing to try has no conditions, or one is not valid
std::vector<lessons::Check> checksOf(const lessons::Document &document, const lessons::Step &step);

/// Checks that the runs of all predictions and solutions exist, and that their conditions and numbers fit them.
/// @throws lessons::DocumentError if not
void checkRuns(const lessons::Document &document, const lessons::Step &step);

}
