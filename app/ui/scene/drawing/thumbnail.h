#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/step.h"

#include <QPixmap>

namespace app {

/// Returns a small image of a step with the given values, after `frames` frames. @throws sim::Error if the
/// scene cannot be composed with them
QPixmap thumbnail(const lessons::Step &step, const sim::Values &values, const Theme &theme, QSize size,
                  int frames = 0);

}
