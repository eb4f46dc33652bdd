#pragma once

#include "app/model/notebook/notebook.h"
#include "app/model/text/user_error.h"

namespace app {

constexpr qint64 largestNotebook = 32 << 20;     ///< bytes
constexpr qint64 largestNotebookRun = 4 << 20;   ///< bytes of one run, without compression
constexpr qint64 largestNotebookRuns = 64 << 20; ///< bytes of all runs together, without compression

/// Returns the ending of the names of notebooks, with its dot.
inline constexpr auto notebookEnding = ".springstep-notebook";

/// Reads a notebook. `name` is its name in messages. Whether its runs are runs is only found out when they are replayed.
/// @throws UserError: not a notebook, wrong types, unknown lessons or names, damaged or too large runs; with the line
Notebook parseNotebook(const QByteArray &text, const QString &name, const LessonLibrary &library);
/// Reads a notebook from a file.
/// @throws UserError: as parseNotebook(), or the file cannot be read or is larger than largestNotebook
Notebook readNotebook(const QString &path, const LessonLibrary &library);

/// Returns the text of a notebook file, with its seal.
/// @throws UserError: too many entries, or too large
QByteArray notebookText(const Notebook &notebook);

}
