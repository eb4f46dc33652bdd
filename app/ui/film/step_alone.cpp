#include "app/ui/film/step_alone.h"

#include <utility>

namespace app {

LessonLibrary stepAlone(const Experiment &experiment, const LessonLibrary &library)
{
    const LessonEntry &lesson = *library.lesson(experiment.lesson);
    lessons::Step step = *lesson.step(experiment.step);
    step.tries.clear();
    step.measures.clear();
    LessonLibrary alone;
    alone.lessons.push_back({lesson.id, lesson.order, lesson.title, lesson.summary, {std::move(step)}});
    return alone;
}

}
