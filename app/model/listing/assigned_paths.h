#pragma once

#include "app/listing/tokens.h"

#include <string>
#include <vector>

namespace app {

/// A statement of a listing that sets a variable or a member.
struct Assignment
{
    int line = 0;          ///< of its path, from 1
    std::string path;      ///< "angle", "foot.velocity", "feet[i].position"
    std::size_t begin = 0; ///< index of the path's first token
    std::size_t value = 0; ///< index of the first token behind the sign; for `++` the token behind it
    std::size_t end = 0;   ///< index of the token that ends the statement
    bool isPlain = false;  ///< whether it is `=`, not `+=` and the like
    bool isInHead = false; ///< whether it stands in the head of a `for`
};

/// Returns the assignments of a text, in its order. The text need not compile.
std::vector<Assignment> assignmentsIn(const listing::Tokens &tokens);

/// Returns whether tokens `i` and `i + 1` are a type and the name of a variable or parameter: `double angle`, or
/// `Vec2 centre` of `Vec2 centre(x, y);`. Functions are left out.
bool declaresVariable(const listing::Tokens &tokens, std::size_t i);

/// Returns the index of the first token of the path that ends with token `last`, such as `feet[i].position`. `last` is a
/// word or a closing bracket.
std::size_t beginOfPath(const listing::Tokens &tokens, std::size_t last);

/// Returns the tokens `begin` to before `end` as a path, without spaces.
std::string joinedPath(const listing::Tokens &tokens, std::size_t begin, std::size_t end);

}
