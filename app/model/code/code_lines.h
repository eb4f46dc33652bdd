#pragma once

#include "app/model/code/code_listing.h"

#include <QHash>

#include <utility>

namespace app {

// Helpers for comparing the lines of two listings.

/// File and line number.
using CodeLinePlace = std::pair<QString, int>;

inline CodeLinePlace placeOf(const CodeLine &line)
{
    return {line.file, line.source.number};
}

/// Returns the text of the line with single spaces. Empty for a line that holds only brackets and semicolons.
QString comparable(const CodeLine &line);
/// Returns how often `listing` has each line. A line that runs in several places counts once.
QHash<QString, int> countsOf(const CodeListing &listing);

}
