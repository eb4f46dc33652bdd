#pragma once

#include "lessons/api/step.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace app {

class Language;

/// A lesson as loaded: what its plugin's metadata says, and its steps.
struct LessonEntry
{
    QString id;
    int order = 0;
    QString title;
    QString summary;
    std::vector<lessons::Step> steps; ///< at least one

    const lessons::Step *step(const QString &id) const;
};

/// A file in a lesson folder that is not a lesson that can be used.
struct LessonProblem
{
    QString file;
    QString why; ///< one clear sentence with the remedy
};

/// Every lesson that loads, by order (then id), and every file that does not. Plugins stay loaded for good:
/// their code lives in the scenes made from them.
struct LessonLibrary
{
    std::vector<LessonEntry> lessons;
    std::vector<LessonEntry>
        workshops; ///< in them a learner builds the scene: their steps take a file's scene
    std::vector<LessonProblem> problems;

    /// The lesson or workshop called `id`, or null.
    const LessonEntry *lesson(const QString &id) const;
    /// All of them by number: the lessons, then the workshops.
    std::size_t entries() const { return lessons.size() + workshops.size(); }
    const LessonEntry &entry(std::size_t number) const
    {
        return number < lessons.size() ? lessons[number] : workshops[number - lessons.size()];
    }

    /// Loads the plugins in `folders`, in that order; of two with one id the first counts. Their texts are in
    /// `language`, which learns what they bring; in English without one.
    static LessonLibrary load(const QStringList &folders, Language *language = nullptr);
    /// Where lessons are looked for: SPRINGSTEP_LESSONS (a list, as PATH is), then beside the program (build
    /// tree), then in the install tree.
    static QStringList folders();
};

}
