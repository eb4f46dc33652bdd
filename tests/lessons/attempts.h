#pragma once

#include "tests/lessons/player.h"
#include "tests/lessons/support.h"

#include <QMetaType>

#include <functional>
#include <vector>

namespace support {

/// What a learner does who follows a "thing to try": the action that its text describes, or nearly so.
struct Attempt
{
    const char *step = nullptr;
    std::size_t number = 0; ///< of the try in its step, from 0
    const char *name = nullptr;
    std::function<void(Player &)> act;
    /// What is still to do after a near miss; empty for an attempt that does it.
    const char *todo = "";

    bool isNearMiss() const { return *todo; }
};

/// An attempt or more for each thing to try of a lesson. Each lesson's suite defines its own, in
/// <lesson>_attempts.cpp.
std::vector<Attempt> attempts();

/// Adds a test row an attempt, and fails the test if a try of `lesson` has none that does it.
void addAttemptRows(const LoadedLesson &lesson, const std::vector<Attempt> &all);

/// Checks the attempt of the current row: not done at the start, and done by it, with something to say about what is
/// missing at each moment on the way. A near miss does not do it, and is told what is still to do.
void checkAttempt(const LoadedLesson &lesson);

}

Q_DECLARE_METATYPE(support::Attempt)
