#pragma once

#include "tests/lessons/support/player.h"
#include "tests/lessons/support/support.h"

#include <QMetaType>

#include <functional>
#include <vector>

namespace support {

/// A scripted attempt at a "thing to try": the action that its text describes, or a near miss.
struct Attempt
{
    const char *step = nullptr;
    std::size_t number = 0; ///< index of the thing to try in its step, from 0
    const char *name = nullptr;
    std::function<void(Player &)> act;
    /// What RunPlayer::missing() returns after a near miss; empty for an attempt that succeeds.
    const char *missing = "";

    bool isNearMiss() const { return *missing; }
};

// At least one attempt for each thing to try of a lesson, in the file of that lesson.
std::vector<Attempt> singleSpringAttempts();
std::vector<Attempt> twoBodyAttempts();
std::vector<Attempt> multiFootAttempts();
std::vector<Attempt> gravityWallsAttempts();
std::vector<Attempt> walkingGaitAttempts();
std::vector<Attempt> swayingTreeAttempts();
std::vector<Attempt> rigidConstraintAttempts();
std::vector<Attempt> codelingAttempts();
std::vector<Attempt> accuracyAttempts();
std::vector<Attempt> hardCasesAttempts();

/// Returns the attempts of the lesson with this id.
std::vector<Attempt> attemptsOf(const std::string &lesson);

/// Adds one test row per attempt. Fails the test if a thing to try of `lesson` has no successful attempt.
void addAttemptRows(const LoadedLesson &lesson, const std::vector<Attempt> &all);

/// Checks the attempt of the current row. The thing to try is not done at the start and is done at the end.
/// Once it has begun, it always has a hint about what is missing. A near miss does not complete it and gets
/// the expected hint.
void checkAttempt(const LoadedLesson &lesson);

}

Q_DECLARE_METATYPE(support::Attempt)
