#pragma once

namespace app {

/// Makes plots known to screen readers, with what is chosen in them as their value. More calls than one do nothing.
void installPlotAccess();

}
