#pragma once

#include "app/model/web/web_page.h"
#include "app/ui/theme/theme.h"

namespace app {

/// Returns the colours of a scheme by the names that a web page uses.
PageColors pageColors(Scheme scheme);

}
