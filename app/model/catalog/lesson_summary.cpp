#include "app/model/catalog/lesson_summary.h"

#include "app/model/catalog/lists.h"

namespace app {

LessonSummary summaryOf(const LessonEntry &lesson, const LessonLibrary &library, const Progress &progress)
{
    LessonSummary summary{.lesson = lesson.id, .title = lesson.title};
    for (const lessons::Step &step : lesson.steps) {
        StepSummary one{.id = step.id, .title = step.title, .learnt = step.explanation.learnt};
        for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
            if (progress.isDone(lesson.id, step.id, i))
                ++one.done;
            else
                one.open << step.tries[static_cast<std::size_t>(i)].text;
        }
        for (const lessons::CodeTask &task : step.codeTasks) {
            if (progress.isWritten(lesson.id, step.id, task.id))
                ++one.written;
            else
                one.unwritten << task.text;
        }
        summary.done += one.done;
        summary.written += one.written;
        summary.codeTasks += static_cast<int>(step.codeTasks.size());
        summary.count += static_cast<int>(step.tries.size());
        summary.steps.push_back(std::move(one));
    }
    if (lesson.project) {
        summary.levels = static_cast<int>(lesson.project->levels.size());
        for (const lessons::ProjectLevel &level : lesson.project->levels) {
            if (progress.isWritten(lesson.id, QLatin1String(projectTicks), level.id))
                ++summary.passed;
            else
                summary.unpassed << level.title;
        }
    }
    const LessonEntry *found = findById(library.lessons, lesson.id);
    if (found && found != &library.lessons.back())
        summary.next = found + 1;
    return summary;
}

}
