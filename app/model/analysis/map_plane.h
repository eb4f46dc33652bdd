#pragma once

namespace app {

/// The vertical axis of a growth map. The horizontal axis is always stiffness.
enum class MapPlane { step, damping };

}
