#pragma once

#include "sim/pipeline/method.h"

#include <QString>

namespace app {

/// What a number that a phase computes is.
struct Meaning
{
    QString unit;
    QString what; ///< in the learner's language; empty: nothing to say beyond the name
};

/// Returns the meaning of the variable `name` ("pull", or "pull.x") in the code of `phase`. The description of the
/// phase's effect goes first, then the table for effects of its kind. Empty if neither has the variable.
Meaning meaningOf(const QString &name, const sim::Phase &phase);

}
