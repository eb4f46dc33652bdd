#pragma once

#include "app/model/experiment/experiment.h"

namespace app {

/// Reads an experiment, and shows that on the terminal if it takes long.
/// @throws UserError: as readExperiment()
Experiment experimentFromFile(const QString &file, const LessonLibrary &library);

/// Returns the experiment for an argument FILE|LESSON/STEP: the file if it exists, otherwise the step.
/// @throws UserError: it is neither a file nor a step, or the file cannot be read
Experiment experimentFor(const QString &argument, const LessonLibrary &library);

}
