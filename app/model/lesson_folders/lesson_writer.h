#pragma once

#include "app/model/experiment/experiment.h"

namespace app {

/// Writes a small but complete lesson with `scene` in a new folder: lesson.json, and a step with a scene and a document,
/// which explains by example what a writer can change. It passes checkLesson() as it is. The learner's input and other runs
/// are left out. A scene of a lesson without C++ brings its parameters along.
/// @throws UserError: the folder exists and is not empty, a file cannot be written, or the files of the scene's own lesson
/// cannot be read; nothing is left behind
void writeLesson(const Experiment &scene, const QString &folder, const LessonLibrary &library);

}
