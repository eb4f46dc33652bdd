#pragma once

#include "sim/base/error.h"
#include "sim/run/track.h"

#include <QString>

#include <string>

namespace app {

/// A text of sim (marked SIM_TEXT) in the learner's language.
QString phrase(const std::string &text);
/// `text` with a capital letter first, as the first word of a line.
QString capitalised(QString text);
/// A name as it stands within a sentence: in German nouns keep their capital letter.
QString withinSentence(const QString &name);

/// What people call the body that files call `name`: "foot 0" for "foot0", "creature 1, foot 0" for
/// "creature1.foot0", "tentacle 2, 5" for "tentacle2_5".
QString bodyTitle(const QString &name);

/// What sim refused, as one clear sentence with the remedy.
QString sentenceFor(const sim::Error &error);

/// The pull of `effect` on `body`, from `other` or, where that is empty, from a place: "The spring foot 3 – body", "What
/// pulls creature 0, foot 1 (gravity)". Bodies by their titles.
QString pullTitle(const sim::Effect &effect, const QString &body, const QString &other);

/// Why a run ended, what went first, and what pulls it hardest.
QString sentenceFor(const sim::Stop &stop);

}
