#pragma once

#include "app/model/experiment/experiment.h"

namespace app {

/// Returns a library with only the experiment's step and no things to try, so that drawing its run ticks nothing.
LessonLibrary stepAlone(const Experiment &experiment, const LessonLibrary &library);

}
