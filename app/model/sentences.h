#pragma once

#include "sim/error.h"
#include "sim/track.h"

#include <QString>

#include <string>

namespace app {

/// A text of sim (marked SIM_TEXT) in the learner's language.
QString phrase(const std::string &text);

/// What people call the body that files call `name`: "foot 0" for "foot0", "creature 1, foot 0" for
/// "creature1.foot0".
QString bodyTitle(const QString &name);

/// What sim refused, as one clear sentence with the remedy.
QString sentenceFor(const sim::Error &error);

/// Why a run ended, as one clear sentence.
QString sentenceFor(const sim::Stop &stop);

}
