#pragma once

#include <QString>

namespace app {

/// Returns the first line of a listing, from `line` (from 1) on, on which a statement of a function begins or a function
/// ends. Lines before it, such as comments and braces, do not run by themselves. Returns 0 if there is none.
int lineOfCodeFrom(const QString &text, int line);

}
