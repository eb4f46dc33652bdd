#pragma once

namespace app {

class HelpPage;

/// Lists what the mouse does, and keys that belong to one part of the window.
void addGestures(HelpPage &page);

}
