#pragma once

#include "lessons/api/checks/budget.h"
#include "lessons/api/checks/condition.h"

#include <QString>

#include <optional>

namespace lessons {

/// A thing to try, and how the machine sees that it was done.
struct Try
{
    QString text = {}; ///< Markdown, one or two short sentences
    /// Looked at after each frame and each change; once all hold, the thing is done. They must not do so at the start
    /// and for a run that nobody touches.
    Conditions conditions = {};
    /// Where there is one, the thing is done only if the run keeps it, too. That is measured only while the conditions
    /// hold, and not after every frame: it takes some milliseconds.
    std::optional<Budget> budget = {};
    /// Whether the thing is to stop at the right moment: it counts only while the run does not play.
    bool onlyWhilePaused = false;
    /// Markdown, one to three sentences: what to drag, to set or to press. May be empty.
    QString hint = {};
    /// Markdown, one or two sentences: what there was to see. Shown when the thing is done; needed where its text asks
    /// something.
    QString answer = {};

    /// Whether all conditions hold at the cursor.
    bool isDone(const sim::Timeline &run) const { return conditions.hold(run); }
};

}
