#pragma once

#include "app/model/experiment/experiment.h"
#include "app/model/lesson_folders/lesson_package.h"

namespace app {

/// Reads a lesson without C++: a folder or its zip (see readLessonFiles()). lessons/README.md describes its files. Its texts
/// are in the language of documentLanguage() where it has them. `library` has the lessons whose scenes it builds on. A
/// lesson in LessonLibrary::yours with the same source may have the same id.
/// @throws UserError: a sentence with the file, the line where there is one, the mistake and the remedy
LessonEntry readLesson(const QString &path, const LessonLibrary &library);

/// Does the same with files that were read before, in the language `language` ("en", "de").
/// @throws UserError as above
LessonEntry lessonOf(const LessonFiles &files, const QString &language, const LessonLibrary &library);

/// Returns the scene with which a step of `lesson` begins, as an experiment of the step of the program that it builds on.
/// Its parameters have the numbers in `values`, where these have them.
/// @throws UserError: a file of the step is missing or has a mistake
Experiment beginningOf(const LessonFiles &lesson, const QString &step, const sim::Values &values,
                       const LessonLibrary &library);

/// Returns the texts of the parameters that a step of `lesson` declares, in the language `language`, with their numbers.
/// @throws UserError as above
std::vector<lessons::ParameterText> parameterTexts(const LessonFiles &lesson, const QString &step,
                                                   const QString &language);

}
