#pragma once

#include "app/ui/theme/theme.h"

#include <QSize>

namespace app {

/// The colours that the learner chose last; light at first.
Scheme keptScheme();
/// The size of text and controls that the learner chose last, in percent: 100 to 200. It holds from the start of the
/// program on: Qt wants to know it before the first window.
int keptSize();
/// Whether a screen of so many px has room for the window at a size, in percent; there is always room for 100.
bool hasRoomFor(int size, QSize screen);

}
