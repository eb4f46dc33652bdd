#pragma once

#include "app/model/experiment/experiment.h"

#include <QImage>

namespace app {

/// Returns a picture of a moment of a run in the light theme, for paper and web pages. Null if computing the run up to there
/// takes more than a few seconds.
QImage pictureOfMoment(const Experiment &experiment, sim::Cursor at, const LessonLibrary &library);

}
