#pragma once

#include "app/listing/vocabulary.h"
#include "app/model/listing/vector_mark.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace app {

/// Returns the names that can continue the word before a position of `text` (both from 1; the column in characters), in
/// alphabetical order: members behind a dot, otherwise variables in the text, names of the scene and words of the language.
/// The word itself may be empty behind a dot only.
QStringList completionsAt(const QString &text, int line, int column, const listing::Vocabulary &vocabulary);

/// Returns the places in `text` that read one of the `parameters` of the scene. Members, functions, and variables of the
/// text with the same name are left out.
std::vector<TextRange> usesOfParameters(const QString &text, const QStringList &parameters);

}
