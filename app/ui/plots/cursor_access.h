#pragma once

namespace app {

/// Makes plots with the cursor of the run known to screen readers, with what they show there as their value. More calls
/// than one do nothing.
void installCursorAccess();

}
