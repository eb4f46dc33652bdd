#pragma once

class QWidget;

namespace app {

/// Puts a dialog that is not shown yet over the middle of its parent's window, inside the screen with its frame. Without a
/// place, a window manager moves a dialog by its frame each time it is shown again.
void placeOverParent(QWidget &dialog);

}
