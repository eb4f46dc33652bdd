#pragma once

#include "app/model/experiment.h"

namespace app {

/// What readExperiment() reads, saying so if that takes long.
Experiment experimentIn(const QString &file, const LessonLibrary &library);

/// What an argument FILE|LESSON/STEP names: a file where there is one of that name, and else a step.
/// @throws Refusal when it names neither, or what it names cannot be read
Experiment experimentNamed(const QString &what, const LessonLibrary &library);

}
