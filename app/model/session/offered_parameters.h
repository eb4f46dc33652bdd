#pragma once

#include "app/model/session/session.h"

namespace app {

/// The parameters of the open step that the scene has a use for, in the step's order.
std::vector<const lessons::Parameter *> offeredParameters(const Session &session);

}
