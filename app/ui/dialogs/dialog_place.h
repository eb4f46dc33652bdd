#pragma once

class QWidget;

namespace app {

/// Centres a dialog that is not shown yet over its parent's window, with its frame inside the screen. Without
/// a position, a window manager shifts a dialog by its frame each time it is shown again.
void placeOverParent(QWidget &dialog);

/// Shows a dialog in front of other windows, placed as by placeOverParent() if it was hidden.
void showInFront(QWidget &dialog);

}
