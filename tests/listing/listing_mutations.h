#pragma once

#include <random>
#include <string>

namespace listing_support {

/// Returns `text` with one to four random changes: bytes, words, lines, signs and numbers.
std::string mutated(std::string text, std::mt19937 &random);

}
