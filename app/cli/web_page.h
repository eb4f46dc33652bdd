#pragma once

#include "app/cli/verbs.h"
#include "app/model/web/web_page.h"

namespace app {

/// Returns whether `film` is asked for a web page: the name of the file ends in .html.
bool isWebPage(const Arguments &arguments);

/// Returns the settings of the web page that the arguments of `film` ask for.
/// @throws UsageError, or UserError: the experiment cannot be read
WebPagePlan pagePlan(const Arguments &arguments, const LessonLibrary &library);

}
