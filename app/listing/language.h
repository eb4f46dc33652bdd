#pragma once

#include "app/listing/vocabulary.h"

#include <string>
#include <string_view>
#include <vector>

namespace listing {

/// Returns whether a body or a parameter can have this name in a listing: a word of ASCII letters, digits and _
/// that the language does not use otherwise. `floor` is usable: in a room it is a number, and not the function.
bool isUsableName(const std::string &name);

/// Returns whether `word` belongs to the interpreter's language but not to that of listings, for example `class`.
bool isLeftOut(std::string_view word);

/// Returns the words of the language itself: `if`, `for`, `double`...
const std::vector<std::string> &keywords();
/// Returns the names that every listing has: `sin`, `pointer`, `frame_number`...
const std::vector<std::string> &commonNames();
/// Returns the names of the bodies of a scene and of its arrays: `body`, `feet`, `creatures`, `sticks`...
std::vector<std::string> bodyNames(const Vocabulary &vocabulary);
/// Returns the names of what a scene remembers besides its bodies: `gait`, `gust`...
std::vector<std::string> clockNames(const Vocabulary &vocabulary);
/// Returns the functions of commonNames().
std::vector<std::string> functionNames();
/// Returns how a function or Vec2 is called, for example "atan2(y, x)"; empty for other names.
std::string formOf(const std::string &function);
/// Returns the members of a type ("Body", "Vec2", "Bodies", "Creature", "Creatures", "Stick", "Sticks", "Children",
/// "Targets", "Keys") in their order; empty for other types.
std::vector<std::string> membersOf(const std::string &type, const Vocabulary &vocabulary);

/// Returns whether two names differ at most by capital letters.
bool isSameButForCase(const std::string &a, const std::string &b);
/// Returns the name of `candidates` that a learner who wrote `word` may have meant: one with a similar spelling, or one
/// that begins like it. Returns an empty string if there is none.
std::string closestName(const std::string &word, const std::vector<std::string> &candidates);

/// Returns "a, b and c".
std::string joined(const std::vector<std::string> &words);

}
