#pragma once

#include "app/model/experiment/json_fields.h"
#include "sim/run/script/script.h"

namespace app {

/// Reads "method", "h" and "tolerance" of a file into `script`, which holds those of the file's step.
/// @throws UserError: an unknown method, an invalid step, or a step that does not fit the method
void readMethod(const QString &file, const JsonFields &fields, sim::Script &script);

}
