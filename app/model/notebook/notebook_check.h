#pragma once

#include "app/model/notebook/notebook.h"
#include "sim/forward.h"

#include <optional>

namespace app {

/// What a replay found about an entry of a notebook.
struct NotebookFinding
{
    enum class Result {
        shown,    ///< the run does what the tick says or the question asks for, or the scene can be opened
        right,    ///< the prediction is good, or the choice right
        off,      ///< the prediction is not good, or the choice not right; that is no fault
        notShown, ///< the run, the code or the answer is not what the notebook says
        noRun,    ///< the run or the code was not recorded
    };
    Result result = Result::shown;
    QString why = {}; ///< one sentence; empty for `shown` and `right`

    bool isFault() const { return result == Result::notShown || result == Result::noRun; }
    friend bool operator==(const NotebookFinding &, const NotebookFinding &) = default;
};

/// The word for a result in tables: "shown", "right", "off", "not shown", "no run".
QString wordFor(NotebookFinding::Result result);

/// Computes the run of an entry again, and finds out whether it does what the entry says. A run that takes longer than
/// half a minute is not shown. A time limit of a thing to try is not measured again, as this machine may be another one.
/// `entry` must be one that parseNotebook() accepts. Returns nothing if `shouldContinue` returned false.
std::optional<NotebookFinding> checkEntry(const NotebookEntry &entry, const LessonLibrary &library,
                                          const sim::ShouldContinue &shouldContinue = {});

}
