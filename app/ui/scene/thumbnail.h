#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/step.h"

#include <QPixmap>

namespace app {

/// A small picture of how a step starts with some values. `frames`: how far it has run by then.
/// @throws sim::Error when the scene does not compose with them
QPixmap thumbnail(const lessons::Step &step, const sim::Values &values, const Theme &theme, QSize size,
                  int frames = 0);

}
