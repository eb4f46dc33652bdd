#pragma once

#include "sim/method.h"

#include <QString>

#include <optional>

namespace app {

/// What a number that a phase computes is.
struct Meaning
{
    const char *name;
    std::optional<sim::Kind> kind; ///< of the phase; empty: any
    const char *unit;
    const char *what; ///< in the context CodeSymbols; empty: nothing to say beyond the name
};

/// What the number called `name` is in `phase`: "pull", or "pull.x"; null where nothing is known of it.
const Meaning *meaningOf(const QString &name, const sim::Phase &phase);

}
