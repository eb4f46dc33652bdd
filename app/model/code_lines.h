#pragma once

#include "app/model/code_listing.h"

#include <utility>

namespace app {

// How lines of two listings are compared.

/// File and line number.
using CodeLinePlace = std::pair<QString, int>;

inline CodeLinePlace placeOf(const CodeLine &line)
{
    return {line.file, line.source.number};
}

/// The line's text without regard to spaces; empty for one that says nothing, as a lone brace.
QString comparable(const CodeLine &line);

}
