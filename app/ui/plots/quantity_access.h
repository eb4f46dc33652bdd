#pragma once

namespace app {

/// Makes plots of quantities known to screen readers, with what they show at the cursor as their value. More calls than
/// one do nothing.
void installQuantityAccess();

}
