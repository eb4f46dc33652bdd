#pragma once

#include "app/model/lesson_library.h"
#include "app/model/progress.h"

#include <vector>

namespace app {

/// What a learner has seen of a step.
struct StepSummary
{
    QString id;
    QString title;
    QString learnt;   ///< may be empty
    int done = 0;     ///< things tried
    QStringList open; ///< Markdown: the things that are still to try
};

/// What a lesson was about, and how far the learner is in it.
struct LessonSummary
{
    QString lesson; ///< id
    QString title;
    std::vector<StepSummary> steps;
    int done = 0;                      ///< things tried
    int count = 0;                     ///< things to try
    const LessonEntry *next = nullptr; ///< the lesson after it; null after the last
};

/// `lesson` must be one of `library`, which must outlive the summary.
LessonSummary summaryOf(const LessonEntry &lesson, const LessonLibrary &library, const Progress &progress);

}
