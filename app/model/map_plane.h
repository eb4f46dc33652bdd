#pragma once

namespace app {

/// The two numbers of a map of growth: stiffness across, and up:
enum class MapPlane { step, damping };

}
