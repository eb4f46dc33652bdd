#pragma once

#include "sim/error.h"
#include "sim/hard/hard_case.h"

namespace sim {

/// Whether a method undertakes to hold a case, and if not, why: an id and values, as of an Error.
struct Claim
{
    bool isMade = false;
    std::optional<Error> why; ///< set if it is not made
};

/// By what the case asks and by what the method says of itself, never by the names of either.
Claim claimOf(const HardCase &hard, const MethodPtr &method, const RunSize &size);

/// By how much the swinging of `stiffest` grows in a step of `method`: below 1 it dies away.
/// The largest of the absolute eigenvalues of what a step makes of places and velocities, found by taking that step
/// from each of them alone, as all of it is linear. Only for methods whose steps have a length.
/// Source: Hairer, Lubich and Wanner, "Geometric numerical integration", section I.1.
double growthOf(const Stiffest &stiffest, const MethodPtr &method, double h);

}
