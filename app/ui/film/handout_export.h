#pragma once

#include "app/model/handout/handout.h"

class QWidget;

namespace app {

/// Returns a function that draws the pictures of a handout. `library` must have its lesson, and outlive the function.
HandoutPicture handoutPicture(const LessonLibrary &library);

/// Returns the number of pictures in the handout of a lesson.
int handoutPictureCount(const LessonEntry &lesson);

/// Asks for a file, and writes the handout of `lesson` into it. Shows the progress in a dialog where it can be cancelled.
/// Returns the file; empty if the user cancelled.
/// @throws UserError if the file cannot be written
QString exportHandout(QWidget &window, const LessonEntry &lesson, const LessonLibrary &library);

}
