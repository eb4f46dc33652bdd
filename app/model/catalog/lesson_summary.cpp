#include "app/model/catalog/lesson_summary.h"

#include <algorithm>

namespace app {

LessonSummary summaryOf(const LessonEntry &lesson, const LessonLibrary &library, const Progress &progress)
{
    LessonSummary summary{lesson.id, lesson.title, {}, 0, 0, nullptr};
    for (const lessons::Step &step : lesson.steps) {
        StepSummary one{step.id, step.title, step.explanation.learnt, 0, {}};
        for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
            if (progress.isDone(lesson.id, step.id, i))
                ++one.done;
            else
                one.open << step.tries[static_cast<std::size_t>(i)].text;
        }
        summary.done += one.done;
        summary.count += static_cast<int>(step.tries.size());
        summary.steps.push_back(std::move(one));
    }
    const auto &all = library.lessons;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto &one) { return one.id == lesson.id; });
    if (found != all.end() && found + 1 != all.end())
        summary.next = &*(found + 1);
    return summary;
}

}
