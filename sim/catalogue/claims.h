#pragma once

#include "sim/base/error.h"
#include "sim/catalogue/hard_case.h"

namespace sim {

/// Whether a method claims to pass a hard case.
struct Claim
{
    bool isMade = false;
    std::optional<Error> why; ///< the reason why it is not made; the app turns it into a sentence
};

/// Returns the claim of `method` for a run of `hardCase`. It depends on the requirements of the case and the
/// declared properties of the method, never on the name of either.
Claim claimOf(const HardCase &hardCase, const MethodPtr &method, const RunSize &size);

/// The predicted oscillation of a StiffestSpring. A stretch is the difference from the rest length.
struct Prediction
{
    double most = 0.0;  ///< px, largest stretch during the run
    double left = 0.0;  ///< px, stretch at the end
    double speed = 0.0; ///< px/frame, change of the stretch in the last step, per frame
};

/// Predicts `steps` steps of length `h` of `method` on `stiffest` alone. The system is linear, so a step is
/// the product with a matrix. Its columns are the results of a step from each unit vector of positions and
/// velocities. Stops when the stretch exceeds `limit` (px). Only for methods with fixed steps.
/// Source: the amplification matrix; Hairer and Wanner, "Solving ordinary differential equations II", section
/// IV.2.
Prediction predictOscillation(const StiffestSpring &stiffest, const MethodPtr &method, double h,
                              std::int64_t steps, double limit);

}
