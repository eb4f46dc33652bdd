#pragma once

#include "app/listing/tokens.h"
#include "app/listing/values.h"

#include <optional>

namespace listing {

// Which texts the interpreter may see. Debian builds AngelScript 2.35.1 with assertions, and some wrong programs end the
// process while it compiles them. These programs, and a few that are only confusing, are rejected here.

/// Returns the first violation of the bounds of limits.h, or the first sign or word that listings leave out: texts in
/// quotes, classes, handles, signs that compute with single bits.
std::optional<CompileError> outsideLanguage(const Tokens &tokens);

/// Returns the first call of a function without a value inside a calculation, assignment inside a calculation or
/// condition, or chain of comparisons such as `a < b < c`. The tokens must be inside the language.
std::optional<CompileError> brokenRule(const Tokens &tokens);

/// Returns whether `word` is the type of a number or of bool.
bool isPrimitive(std::string_view word);
/// Returns the error at `token` with this sentence.
CompileError errorAt(const Token &token, std::string sentence);
/// Returns 'text'.
std::string quoted(std::string_view text);

}
