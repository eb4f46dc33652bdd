#pragma once

#include "lessons/api/checks/budget.h"
#include "lessons/api/checks/condition.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace lessons {

/// The test that shows whether a thing to try is done. `id` is that of its text in the step's document; the other
/// members are those of Try.
struct Check
{
    QString id = {};
    Conditions conditions = {};
    std::optional<Budget> budget = {};
    bool onlyWhilePaused = false;
};

/// Answers to choose from. Empty, or two to four.
struct Choices
{
    QStringList texts = {}; ///< Markdown
    int right = 0;          ///< index

    bool isEmpty() const { return texts.isEmpty(); }
};

/// A thing to try, and the test that shows whether it is done.
struct Try
{
    QString text = {}; ///< Markdown, one or two short sentences
    /// Tested after each frame and each edit. The thing is done once all conditions hold. They must not hold
    /// at the start, nor in a run without input.
    Conditions conditions = {};
    /// If set, the run must also stay within this budget. It is tested only while the conditions hold, and
    /// not after every frame, because the test takes some milliseconds.
    std::optional<Budget> budget = {};
    /// Whether the conditions count only while the run is paused. For things to try that ask to stop at the
    /// right moment.
    bool onlyWhilePaused = false;
    /// Markdown, one to three sentences: what to drag, set or press. May be empty.
    QString hint = {};
    /// Markdown, one or two sentences: the answer to its question. Shown when the thing is done. Required if the
    /// text asks a question.
    QString answer = {};
    /// Made of a to z, 0 to 9 and _. No other thing to try of the step has it.
    QString id = {};
    /// What a learner can answer before she tries. Only with an `answer`.
    Choices choices = {};

    /// Returns whether all conditions hold at the cursor.
    bool isDone(const sim::Timeline &run) const { return conditions.hold(run); }
};

}
