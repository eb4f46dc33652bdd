#pragma once

namespace app {

class HelpPage;

/// Lists the mouse gestures, and the keys that work in only one part of the window.
void addGestures(HelpPage &page);

}
