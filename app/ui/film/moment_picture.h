#pragma once

#include "app/model/experiment/experiment.h"

#include <QImage>

namespace app {

/// Draws a moment of a run on light ground, for paper and web pages. Null if the run does not reach it in a few seconds.
QImage pictureOfMoment(const Experiment &experiment, sim::Cursor at, const LessonLibrary &library);

}
