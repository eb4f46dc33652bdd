#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/catalog/progress.h"

#include <vector>

namespace app {

/// A learner's progress in one step.
struct StepSummary
{
    QString id;
    QString title;
    QString learnt;             ///< may be empty
    int done = 0;               ///< things tried
    QStringList open = {};      ///< the things still to try
    int written = 0;            ///< tasks in the listing that are done
    QStringList unwritten = {}; ///< the tasks in the listing that are not
};

/// A summary of a lesson and the learner's progress in it.
struct LessonSummary
{
    QString lesson; ///< id
    QString title;
    std::vector<StepSummary> steps = {};
    int done = 0;                      ///< things tried
    int count = 0;                     ///< things to try
    int written = 0;                   ///< tasks in listings that are done
    int codeTasks = 0;                 ///< tasks in listings
    int passed = 0;                    ///< levels of the project that are passed
    int levels = 0;                    ///< levels of the project
    QStringList unpassed = {};         ///< the titles of the levels that are not passed
    const LessonEntry *next = nullptr; ///< the next lesson; null after the last one
};

/// Returns the summary of `lesson`. `lesson` must belong to `library`, which must outlive the summary.
LessonSummary summaryOf(const LessonEntry &lesson, const LessonLibrary &library, const Progress &progress);

}
