#pragma once

#include "app/model/experiment.h"

namespace app {

// An experiment as one line of text, which fits a message.

/// The most that a line may be long, in characters.
constexpr qsizetype longestLine = 1 << 20;

/// JSON without line breaks, or where that is shorter "springstep:" and the same compressed by zlib, in base64url
/// (RFC 4648). @throws Refusal: longer than longestLine, or what experimentText() refuses
QString experimentLine(const Experiment &experiment, const LessonLibrary &library);

/// Reads either of them, or JSON as files have it; white space round it and line breaks of a mail do not count.
/// @throws Refusal: neither, cut off, or what a file would be refused for
Experiment experimentFromLine(const QString &line, const LessonLibrary &library);

}
