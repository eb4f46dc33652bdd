#pragma once

#include "app/model/experiment/experiment.h"

namespace app {

// An experiment as one line of text that fits into a message.

/// The largest length of a line, in characters.
constexpr qsizetype longestLine = 1 << 20;

/// Returns an experiment as JSON without line breaks. If shorter, returns "springstep:" and the JSON compressed by
/// zlib, in base64url (RFC 4648).
/// @throws UserError: longer than longestLine, or as experimentText()
QString experimentLine(const Experiment &experiment, const LessonLibrary &library);
/// Does the same for `json`, the text of an experiment file.
/// @throws UserError: longer than longestLine
QString lineOf(const QByteArray &json);
/// Returns the JSON text that such a line contains. It is not checked whether it is an experiment.
/// @throws UserError: incomplete text, or more than `largest` bytes
QByteArray textInLine(const QString &line, qint64 largest = largestExperiment);

/// Reads either of these forms, or JSON as in files. Ignores surrounding white space and line breaks from e-mails.
/// @throws UserError: neither form, incomplete text, or as parseExperiment()
Experiment experimentFromLine(const QString &line, const LessonLibrary &library);

}
