#pragma once

#include <QString>

namespace app {

/// Returns the first line of a listing, from `line` (from 1) on, on which a statement of a function begins or a function
/// ends. Lines before it, such as comments and braces, do not run by themselves. Returns 0 if there is none.
int lineOfCodeFrom(const QString &text, int line);

/// Returns the line of the innermost brace that the lines before `line` (from 1) leave open; 0 if there is none.
int lineOfOpenBrace(const QString &text, int line);

/// Returns whether `code`, the beginning of a listing, ends with the head of an `if` or a loop, or with `else`, so that
/// its statement comes next.
bool endsWithHead(const QString &code);

}
