#pragma once

#include "app/model/json_fields.h"
#include "sim/run/script/script.h"

namespace app {

/// Reads "method", "h" and "tolerance" of a file into `script`, which has those of the file's step.
/// @throws Refusal: no such method, a step that there is not, or one that does not go with the method
void readMethod(const QString &file, const JsonFields &fields, sim::Script &script);

}
