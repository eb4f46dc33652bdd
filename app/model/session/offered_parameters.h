#pragma once

#include "app/model/session/run_editor.h"

namespace app {

/// The parameters of the step that the scene has a use for, in the step's order.
std::vector<const lessons::Parameter *> offeredParameters(const OpenRun &run, const RunEditor &editor);

}
