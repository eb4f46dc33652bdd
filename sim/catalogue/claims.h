#pragma once

#include "sim/base/error.h"
#include "sim/catalogue/hard_case.h"

namespace sim {

/// Whether a method undertakes to hold a case, and if not, why: an id and values, as of an Error.
struct Claim
{
    bool isMade = false;
    std::optional<Error> why; ///< set if it is not made
};

/// By what the case asks and by what the method says of itself, never by the names of either.
Claim claimOf(const HardCase &hard, const MethodPtr &method, const RunSize &size);

/// What some steps make of the spring of a Stiffest.
struct Prediction
{
    double most = 0.0;  ///< px: the farthest that it was out of its length on the way
    double left = 0.0;  ///< px: that it is in the end
    double speed = 0.0; ///< px/frame: from its place a step before, in the end
};

/// Takes `steps` steps of `method` on `stiffest` alone. All of it is linear, so a step is a matrix, found by taking it
/// from each place and each velocity alone. Leaves off where the spring is more than `enough` px out of its length.
/// Only for methods whose steps have a length.
/// Source: the amplification matrix; Hairer and Wanner, "Solving ordinary differential equations II", section IV.2.
Prediction predictOscillation(const StiffestSpring &stiffest, const MethodPtr &method, double h,
                              std::int64_t steps, double enough);

}
