#pragma once

#include "app/listing/vocabulary.h"

#include <QString>
#include <QStringList>

namespace app {

/// Returns the names that can continue the word before a position of `text` (both from 1; the column in characters), in
/// alphabetical order: members behind a dot, otherwise variables in the text, names of the scene and words of the language.
/// The word itself may be empty behind a dot only.
QStringList completionsAt(const QString &text, int line, int column, const listing::Vocabulary &vocabulary);

}
