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

/// What the number called `name` is in `phase`: "pull", or "pull.x". Its effect's description comes before what all
/// effects of its kind have in common. Empty where nothing is known of it.
Meaning meaningOf(const QString &name, const sim::Phase &phase);

}
