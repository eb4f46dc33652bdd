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

/// Begins the function that returns the attempts of `lesson`: at least one for each of its things to try. The file
/// LESSON.cpp in this folder has it.
#define ATTEMPTS(lesson) std::vector<Attempt> attempts_of_##lesson()

/// Returns the attempts of the lesson with this id. A lesson without things to try has none.
std::vector<Attempt> attemptsOf(const std::string &lesson);

}

Q_DECLARE_METATYPE(support::Attempt)
