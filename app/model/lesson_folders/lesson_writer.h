#pragma once

#include "app/model/experiment/experiment.h"

namespace app {

/// Writes a small but complete lesson with `scene` in a new folder: lesson.json, and a step with a scene and a document,
/// which explains by example what a writer can change. It passes checkLesson() as it is. The learner's input and other runs
/// are left out.
/// @throws UserError: the folder exists and is not empty, a file cannot be written, or the scene belongs to a lesson without
/// C++; nothing is left behind
void writeLesson(const Experiment &scene, const QString &folder, const LessonLibrary &library);

}
