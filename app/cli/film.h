#pragma once

#include "app/cli/film_arguments.h"

namespace app {

/// `springstep film FILE OUT`: makes a film of a run. Needs a QApplication. Returns the exit code.
int makeFilm(const FilmRequest &request);

}
