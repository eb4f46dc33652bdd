#pragma once

#include "app/model/lesson_library.h"

namespace app {

/// Loads the lesson in a plugin file. Nothing of the file runs before its metadata is what a lesson has.
/// Its texts are in `language` where there is one, which learns what the plugin brings.
/// @throws Refusal: one sentence on what the file is and what to do with it
LessonEntry loadLesson(const QString &file, Language *language);

}
