#pragma once

#include <cstddef>

// Bounds on listings, so that a file from a stranger can be opened. Within them, compiling takes milliseconds and
// a frame takes less than a second.

namespace listing {

constexpr std::size_t maxTextBytes = 20'000;
constexpr int maxLinesPerFrame = 100'000;
/// Lines of one call of `force` or `pull` in a rule. An evaluation calls it for each body.
constexpr int maxLinesPerRuleCall = 10'000;
/// Lines that a trace keeps. A longer frame is computed to its end, but its further lines are not kept.
constexpr int maxTracedLines = 10'000;
constexpr int maxCallDepth = 100;
/// Brackets inside brackets.
constexpr int maxNesting = 40;
/// Words and signs of a statement, with those of the statements that hang on it without braces.
constexpr int maxStatementTokens = 500;
/// `else` in one listing: each is nested in the one before.
constexpr int maxElses = 200;
/// Bytes of all global variables.
constexpr std::size_t maxMemoryBytes = 8'192;

}
