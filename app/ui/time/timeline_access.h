#pragma once

namespace app {

/// Makes timelines accessible to screen readers, as sliders with frame and phase. Further calls do nothing.
void installTimelineAccess();

}
