#pragma once

#include "lessons/api/prediction.h"
#include "lessons/api/text/document_scan.h"
#include "lessons/api/try.h"

#include <QString>

namespace lessons {

/// Reads a section “## Predict {#id}”. `file` is the name that errors show.
/// @throws DocumentError if a text or a field is missing, unknown or there twice
Prediction parsePrediction(const DocumentSection &section, const QString &id, const QString &file);

/// Reads the list below “### Choices”: two to four items “- [ ] text”, of which one is “- [x] text”.
/// @throws DocumentError if it is another list
Choices parseChoices(const DocumentPart &field, const QString &file);

}
