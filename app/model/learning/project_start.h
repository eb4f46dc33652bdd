#pragma once

#include "app/model/experiment/experiment.h"

namespace app {

/// Returns the experiment that the project of a lesson starts with. Its lesson and step are the place where the learner
/// works.
/// @throws UserError: there is none, or as parseExperiment(); the lesson is at fault then
Experiment projectStart(const LessonEntry &lesson, const LessonLibrary &library);

}
