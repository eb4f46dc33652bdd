#pragma once

#include "app/listing/tokens.h"
#include "app/listing/values.h"

#include <optional>

namespace listing {

/// Returns the first mistake that beginners often make, or nothing. The interpreter would report each of them as another
/// mistake, or on another line: a decimal comma, `(x, y)` for a Vec2, code outside of functions, `if` without brackets.
std::optional<CompileError> commonSlip(const Tokens &tokens);

/// Returns the first statement that computes a value and does nothing with it, such as `a + b;`. The tokens must be those of a
/// text that compiles.
std::optional<CompileError> unusedValue(const Tokens &tokens);

/// Returns whether token `i` begins a value that is set or returned and may have a fraction. As far as its words tell,
/// a calculation has none if it consists of whole numbers, `int` variables, counts and `floor(...)`.
bool setsFraction(const Tokens &tokens, std::size_t i);

}
