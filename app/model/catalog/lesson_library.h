#pragma once

#include "lessons/api/step.h"
#include "lessons/api/text/project.h"
#include "lessons/api/text/recall.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace app {

class Language;

/// A loaded lesson: its plugin's metadata and its steps.
struct LessonEntry
{
    QString id;
    int order = 0;
    QString title;
    QString summary;
    std::vector<lessons::Step> steps; ///< at least one
    lessons::Recall recall = {};      ///< without questions if the lesson has none
    std::optional<lessons::Project> project = {};

    const lessons::Step *step(const QString &id) const;
};

/// A file in a lesson folder that cannot be used as a lesson.
struct LessonProblem
{
    QString file;
    QString why; ///< one clear sentence with the remedy
};

/// All lessons that load, sorted by order and id, and all files that do not load. Plugins are never unloaded:
/// scenes made from them use their code.
struct LessonLibrary
{
    std::vector<LessonEntry> lessons;
    std::vector<LessonEntry> sandboxes; ///< learners build the scene; their steps take a scene from a file
    std::vector<LessonProblem> problems;

    /// Returns the lesson or sandbox with this `id`, or null.
    const LessonEntry *lesson(const QString &id) const;
    /// Returns the number of entries: the lessons, then the sandboxes.
    std::size_t entries() const { return lessons.size() + sandboxes.size(); }
    const LessonEntry &entry(std::size_t number) const
    {
        return number < lessons.size() ? lessons[number] : sandboxes[number - lessons.size()];
    }

    /// Loads the plugins in `folders`, in that order. If two have the same id, the first is used. Their texts are
    /// in `language`, which also loads their translations. Without `language`, the texts are in English.
    static LessonLibrary load(const QStringList &folders, Language *language = nullptr);
    /// Returns the folders to search for lessons: SPRINGSTEP_LESSONS (a list like PATH), then beside the program
    /// (build tree), then the install tree.
    static QStringList folders();
};

}
