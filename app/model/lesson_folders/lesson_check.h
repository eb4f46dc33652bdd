#pragma once

#include "app/model/lesson_folders/lesson_folder.h"
#include "sim/forward.h"

#include <vector>

namespace app {

/// One thing that was checked in a lesson.
struct LessonFinding
{
    enum class Kind {
        listing,    ///< it computes the same motion as the method of its step
        thing,      ///< a thing to try: its solution does it, and doing nothing does not
        prediction, ///< its run ends as its document says
        task,       ///< its solution passes, the empty place does not, and each near miss is recognised
        question,   ///< a recall question: if it is answered by doing, its solution does that
        level,      ///< the solution of a level of the project passes, and the start scene does not
    };
    Kind kind = Kind::thing;
    QString step; ///< id; empty for questions and levels
    QString id;   ///< of the thing; empty for a listing
    bool isGood = false;
    QString sentence; ///< what was found: "done in frame 45"
};

/// Carries out all that a lesson asks for, with the solutions that it states. Stops early, with what it has found so far, when
/// `shouldContinue` returns false.
std::vector<LessonFinding> checkLesson(const LessonFiles &files, const LessonEntry &lesson,
                                       const LessonLibrary &library,
                                       const sim::ShouldContinue &shouldContinue = {});

/// Returns the word for a kind in tables and JSON: "try", "prediction".
QString wordFor(LessonFinding::Kind kind);

}
