#pragma once

#include "app/model/catalog/lesson_library.h"

#include <optional>
#include <vector>

namespace app {

/// A question whose answer a notebook has: a recall question, or a thing to try with choices.
struct NotebookQuestion
{
    QString text;                                    ///< Markdown
    std::vector<lessons::RecallChoice> choices = {}; ///< in the order of the document
    std::size_t right = 0;                           ///< index of the right choice
    const lessons::RecallTask *task = nullptr;       ///< to do in a scene; null: the question has choices

    /// Returns the choice that `said` names by its number, from 1; null if there is none.
    const lessons::RecallChoice *choice(const QString &said) const;
    bool isRight(const QString &said) const { return choice(said) == &choices[right]; }
};

/// Returns the recall question of `lesson` with this id if `step` is empty, and otherwise the question of the thing to try.
/// Empty if there is none. It is valid as long as `lesson`.
std::optional<NotebookQuestion> notebookQuestion(const LessonEntry &lesson, const QString &step,
                                                 const QString &id);

}
