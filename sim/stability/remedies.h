#pragma once

#include "sim/script.h"
#include "sim/stability/stability.h"

#include <string>
#include <vector>

namespace sim {

/// A change that brings a run back from its method's limit.
struct Remedy
{
    enum class Kind {
        smallerStep,     ///< the same method at `step`
        moreDamping,     ///< the parameter at `value`
        holdingMethod,   ///< another method whose limit at the same step is far
        boundlessMethod, ///< another method, without such a limit
    };
    Kind kind = Kind::smallerStep;
    MethodPtr method;
    StepSize step;
    double value = 0.0;
    double share = 0.0; ///< of the limit, after it; 0 where there is none
};

/// The parameter of a scene that slows its velocities, and where it may go: the smaller, the more damping.
struct DampRange
{
    std::string parameter;
    double least = 0.0;
    double grid = 0.01; ///< values that are looked at are multiples of it
};

/// Shares of the limit that a remedy must reach.
constexpr double wellHeld = 0.6; ///< by a smaller step or another method
constexpr double justHeld = 0.9; ///< by damping

/// What would mend a step that is past wellHeld of its limit, the least change first; each found by measuring it. The
/// step is the largest power of 1/2 a frame, the damping the least, another method the one with the fewest forces
/// computed a step. None where nothing needs mending, and only what really does it.
/// @param values in force, with which `state` came about
/// @param damp null where the scene has no such parameter
std::vector<Remedy> remediesFor(const Script &script, const Values &values, const State &state,
                                const Stability &now, const DampRange *damp);

}
