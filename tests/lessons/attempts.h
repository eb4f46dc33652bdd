#pragma once

#include "tests/lessons/player.h"
#include "tests/lessons/support.h"

#include <QMetaType>

#include <functional>
#include <vector>

namespace support {

/// What a learner does who follows a "thing to try": the action that its text describes.
struct Attempt
{
    const char *step = nullptr;
    std::size_t number = 0; ///< of the try in its step, from 0
    const char *name = nullptr;
    std::function<void(Player &)> act;
};

/// An attempt or more for each thing to try of a lesson. Each lesson's suite defines its own, in
/// <lesson>_attempts.cpp.
std::vector<Attempt> attempts();

/// Adds a test row an attempt, and fails the test if a try of `lesson` has none.
void addAttemptRows(const LoadedLesson &lesson, const std::vector<Attempt> &all);

/// Checks the attempt of the current row: not done at the start, and done by it.
void checkAttempt(const LoadedLesson &lesson);

}

Q_DECLARE_METATYPE(support::Attempt)
