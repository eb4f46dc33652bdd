#pragma once

#include "sim/scene/scene.h"

namespace sim {

/// Carries what `state` of scene `from` has over to scene `to`: bodies of the same name go on as they are,
/// turned by as much as their start is turned; new ones stand where `to` starts them, shifted by as much as the
/// others have moved on the average.
State transferState(const State &state, const Scene &from, const Scene &to);

}
