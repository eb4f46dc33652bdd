#pragma once

#include "lessons/api/explanation.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace lessons {

struct Document;
struct Step;

/// Takes the braces out of the lines below a “## Why:” and returns their formulas. lessons/README.md describes what can
/// stand in braces. `firstLine` is the line of the document at which `lines` begins, from 1. `file` is the name that errors
/// show.
/// @throws DocumentError if there is something else in braces, or if they are not behind a formula
std::vector<Formula> takeFormulas(QStringList &lines, int firstLine, const QString &file);

/// Checks that the scene of `step` has all that the formulas of `document` highlight.
/// @throws DocumentError if not
void checkHighlights(const Document &document, const Step &step);

}
