#pragma once

#include <QString>

#include <string>

namespace app {

/// Returns a sentence of a listing's compiler, or of a mistake that stopped it, in the learner's language.
QString listingSentence(const std::string &text);

}
