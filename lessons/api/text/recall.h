#pragma once

#include "lessons/api/prediction.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace lessons {

/// An answer to choose for a recall question.
struct RecallChoice
{
    static constexpr qsizetype longest = 90; ///< characters

    QString text;        ///< Markdown, one paragraph
    QString explanation; ///< Markdown: why it is right or wrong; empty only if it is right
};

/// A part of a recall question that is answered by doing something in the scene of a step.
struct RecallTask
{
    RunSetup setup; ///< `setup.step` is the scene that opens; the task is done once `setup.until` holds
    QString answer; ///< Markdown, shown when the task is done
    /// A run that does it, beside what `setup` says. Without `frames` if the document does not say.
    RunSetup solution = {};
};

/// A question after a lesson. It has choices, or a task.
struct RecallQuestion
{
    QString id;   ///< made of a to z, 0 to 9 and _. No other question of the lesson has it.
    QString text; ///< Markdown
    std::vector<RecallChoice> choices = {}; ///< the right one comes first
    std::optional<RecallTask> task = {};
    int line = 0; ///< of its heading, from 1
};

/// The questions after a lesson, in one language.
struct Recall
{
    QString file; ///< the name that errors show
    QString title;
    QString text; ///< Markdown, one sentence below the title
    std::vector<RecallQuestion> questions = {};
};

/// Reads the questions of a lesson. lessons/README.md describes the format. `file` is the name that errors show.
/// Steps, parameters and conditions are not looked up.
/// @throws DocumentError if a heading or a text is missing, unknown or there twice, or if `source` is not UTF-8
Recall parseRecall(const QByteArray &source, const QString &file);

/// Returns the questions in the resource `:/documents/LESSON/recall.md`, in the language of documentLanguage() if it is
/// there and otherwise in English. Empty if the lesson has none.
/// @throws DocumentError as parseRecall()
Recall readRecall(const QString &lesson);

}
