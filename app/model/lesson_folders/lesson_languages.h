#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/lesson_folders/lesson_package.h"

namespace app {

/// Returns the codes of the languages that a lesson is translated into, sorted, such as "de". All other languages show
/// the documents that have no code in their names.
QStringList languagesOf(const LessonFiles &files);

/// Checks that the documents of a lesson in one language ask the same as those in another: things to try, predictions and
/// questions have the same ids, runs and conditions.
/// @throws UserError if not
void checkSameQuestions(const LessonEntry &one, const LessonEntry &other);

}
