#pragma once

#include "lessons/api/step.h"
#include "lessons/api/text/project.h"
#include "lessons/api/text/recall.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <deque>
#include <optional>
#include <vector>

namespace app {

class Language;

/// A loaded lesson: its metadata and its steps.
struct LessonEntry
{
    QString id;
    int order = 0;
    QString title;
    QString summary;
    std::vector<lessons::Step> steps; ///< at least one
    lessons::Recall recall = {};      ///< without questions if the lesson has none
    std::optional<lessons::Project> project = {};
    /// The folder or file that a lesson without C++ was read from; see readLesson(). Empty for a plugin.
    QString source = {};
    QByteArray projectStart = {}; ///< likewise, the experiment that its project starts with

    const lessons::Step *step(const QString &id) const;
};

/// A file among the lessons that cannot be used as a lesson.
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
    std::deque<LessonEntry> yours;      ///< lessons without C++; one that is added moves no other
    std::vector<LessonProblem> problems;

    /// Returns the lesson or sandbox with this `id`, or null.
    const LessonEntry *lesson(const QString &id) const;
    /// Returns the number of entries: the lessons, then the sandboxes, then `yours`.
    std::size_t entries() const { return lessons.size() + sandboxes.size() + yours.size(); }
    const LessonEntry &entry(std::size_t number) const
    {
        const std::size_t built = lessons.size() + sandboxes.size();
        return number < lessons.size() ? lessons[number]
               : number < built        ? sandboxes[number - lessons.size()]
                                       : yours[number - built];
    }

    /// Loads the plugins in `folders`, in that order, and then the lessons without C++ there. If two have the same id,
    /// the first is used. Their texts are in `language`, which also loads their translations. Without `language`, the
    /// texts are in English.
    static LessonLibrary load(const QStringList &folders, Language *language = nullptr);
    /// Returns the folders to search for lessons: SPRINGSTEP_LESSONS (a list like PATH), then beside the program
    /// (build tree), then the install tree.
    static QStringList folders();
};

}
