#pragma once

#include "app/model/catalog/lesson_library.h"

#include <QJsonObject>

namespace app {

/// The metadata of a lesson.
struct LessonDescription
{
    LessonEntry lesson; ///< without its steps
    QStringList steps;  ///< their ids
};

/// Reads a lesson's metadata in the form of lesson.json.
/// @throws UserError: a field is missing or has a wrong value
LessonDescription describedLesson(const QJsonObject &data);

/// Loads the lesson in a plugin file. Checks its metadata before any code of the file runs. The texts are in
/// `language`, if given, which also loads the plugin's translations.
/// @throws UserError with a sentence that says what is wrong with the file and how to fix it
LessonEntry loadLesson(const QString &file, Language *language);

}
