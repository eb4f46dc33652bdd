#pragma once

#include "app/model/notebook/notebook_page.h"

namespace app {

/// Returns a function that draws the moments of entries whose runs can be replayed. `library` must outlive it.
EntryPicture entryPicture(const LessonLibrary &library);

}
