#pragma once

#include "app/model/catalog/lesson_library.h"
#include "sim/run/script/script.h"

#include <QImage>

#include <functional>

class QTextDocument;

namespace app {

/// A moment of a run that a handout shows.
struct HandoutMoment
{
    const LessonEntry &lesson;
    const lessons::Step &step;
    sim::Script script;
    std::int64_t frame = 0;
};

/// Returns a picture of a moment, on light ground; null if there is none.
using HandoutPicture = std::function<QImage(const HandoutMoment &moment)>;

/// Writes a lesson on paper into `document`, in the language of `lesson`: the text and the listing of each step, its
/// predictions with a picture of where they begin, things to try and tasks with lines to write on, the questions after the
/// lesson and its project. The answers begin on a new page, with pictures of where the predictions end. Returns
/// false if cancelled.
/// @throws UserError, sim::Error if a prediction has no run
bool writeHandout(QTextDocument &document, const LessonEntry &lesson, const HandoutPicture &picture,
                  const sim::ShouldContinue &shouldContinue);

}
