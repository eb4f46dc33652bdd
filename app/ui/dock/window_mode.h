#pragma once

namespace app {

/// What the window is arranged for. Each mode has layouts of its own.
enum class WindowMode { learn, measure, build };

}
