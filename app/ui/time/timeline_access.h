#pragma once

namespace app {

/// Makes timelines known to screen readers, as sliders that tell frame and phase. More calls than one do nothing.
void installTimelineAccess();

}
