#pragma once

#include "app/cli/verbs.h"
#include "app/model/catalog/lesson_library.h"

namespace app {

/// Returns whether `film` is asked for a web page: the name of the file ends in .html.
bool isWebPage(const Arguments &arguments);

/// Makes the web page that the arguments of `film` ask for. Returns the exit code.
/// @throws UsageError, UserError
int runWebPage(const Arguments &arguments, const LessonLibrary &library);

}
