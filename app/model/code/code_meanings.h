#pragma once

#include "sim/pipeline/method.h"

#include <QString>

namespace app {

/// The unit and description of a number that a phase computes.
struct Meaning
{
    QString unit;
    QString what; ///< in the learner's language; empty if the name says enough
};

/// Returns the meaning of the variable `name` ("pull", or "pull.x") in the code of `phase`. The description of the
/// phase's effect takes precedence over the table for effects of its kind. Empty if neither has the variable.
Meaning meaningOf(const QString &name, const sim::Phase &phase);

}
