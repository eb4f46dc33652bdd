#pragma once

namespace app {

/// What one press of the step commands runs: a phase of the method, or a line of the listing.
enum class StepBy { phases, lines };

}
