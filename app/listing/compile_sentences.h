#pragma once

#include "app/listing/vocabulary.h"

#include <string>
#include <vector>

namespace listing {

/// The place in a listing that a message of the interpreter is about.
struct MarkedPlace
{
    std::string word; ///< the word or sign there; may be empty
    const Vocabulary &vocabulary;
    std::vector<std::string> declared; ///< names that the listing declares itself
    std::string next = {};             ///< the word or sign behind `word`
    bool isMember = false;             ///< whether a dot stands before `word`
    std::string form = {};             ///< how `word` is called if it is a function of the listing
    /// For a message of isAboutGap(): whether something is missing behind `word`, the last word or sign of its line.
    bool isAtLineEnd = false;
};

/// Translates an error message of the interpreter into one or two plain sentences: what is wrong, and which names exist.
std::string plainSentence(const std::string &message, const MarkedPlace &place);

/// Returns whether a message of the interpreter says that an `int` gets a number with a fraction.
bool isAboutFraction(const std::string &message);

/// Returns whether a message of the interpreter says that something cannot be changed. Its position is behind that.
bool isAboutChange(const std::string &message);

/// Returns whether a message of the interpreter says that something is missing. Its position is behind the gap.
bool isAboutGap(const std::string &message);

}
