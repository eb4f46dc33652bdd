#pragma once

class QKeyEvent;
class QWidget;

namespace app {

/// Returns whether the widget with the focus uses this key itself, so that no shortcut of the window may take it.
/// Qt's own buttons, sliders and lists use arrows, Home, End or Space, but do not claim them.
bool usesKey(const QWidget &focus, const QKeyEvent &key);

}
