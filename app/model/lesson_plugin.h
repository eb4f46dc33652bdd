#pragma once

#include "app/model/lesson_library.h"

#include <QJsonObject>

namespace app {

/// What a lesson's metadata says.
struct LessonDescription
{
    LessonEntry lesson; ///< without its steps
    QStringList steps;  ///< their ids
};

/// Reads a lesson's metadata, as lesson.json has it. @throws Refusal: something is missing, or is not what it should be
LessonDescription describedLesson(const QJsonObject &data);

/// Loads the lesson in a plugin file. Nothing of the file runs before its metadata is what a lesson has.
/// Its texts are in `language` where there is one, which learns what the plugin brings.
/// @throws Refusal: one sentence on what the file is and what to do with it
LessonEntry loadLesson(const QString &file, Language *language);

}
