#pragma once

#include "sim/base/error.h"
#include "sim/run/track.h"

#include <QString>

#include <string>

namespace app {

/// Returns a text of sim (marked SIM_TEXT) in the learner's language.
QString phrase(const std::string &text);
/// Returns `text` with its first letter capitalised.
QString capitalised(QString text);
/// Returns a name as it is written within a sentence. German nouns keep their capital letter.
QString withinSentence(const QString &name);

/// Returns the title of a body from its name in files. Examples: "foot 0" for "foot0", "creature 1, foot 0" for
/// "creature1.foot0", "tentacle 2, 5" for "tentacle2_5".
QString bodyTitle(const QString &name);

/// Returns one clear sentence for an error of sim, with the remedy.
QString sentenceFor(const sim::Error &error);

/// Returns the title of the pull of `effect` on `body`: "The spring foot 3 – body", "The force on creature 0, foot
/// 1 (gravity)". `other` is the second body, or empty if the pull comes from a place. Both bodies are given by their
/// titles.
QString pullTitle(const sim::Effect &effect, const QString &body, const QString &other);

/// Returns why a run ended, which body failed first, and what pulls it hardest.
QString sentenceFor(const sim::Stop &stop);

}
