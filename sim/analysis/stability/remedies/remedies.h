#pragma once

#include "sim/analysis/stability/stability.h"
#include "sim/run/script/script.h"

#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A change to a run that mends it.
struct Remedy
{
    enum class Kind {
        smallerStep,     ///< the same method at `step`
        largerTolerance, ///< likewise
        moreDamping,     ///< `parameter` at `value`
        moreIterations,  ///< likewise
        stableMethod,    ///< another method whose limit at the same step is far
        unlimitedMethod, ///< another method, without such a limit
    };
    Kind kind = Kind::smallerStep;
    MethodPtr method;
    StepSize step;
    double value = 0.0;
    double share = 0.0; ///< of the limit, after it; 0 where there is none, or nobody asked
    std::string parameter;
    /// How many frames of a run with it were tried, and held; 0 where none were.
    std::int64_t stableFrames = 0;
    /// px: how wrong it leaves sticks; empty for what is not about sticks.
    std::optional<double> stickError = {};

    /// Whether it is a parameter that changes; else the method and its step.
    bool setsParameter() const { return kind == Kind::moreDamping || kind == Kind::moreIterations; }
    /// Another method or step.
    static Remedy of(Kind kind, const MethodPtr &method, StepSize step, double share = 0.0);
};

/// `script` with that change from its start on. All else, and all that a learner did, stays as it was; but where a
/// parameter was set to less of the same on the way (less damping, fewer passes), it is set to that of the remedy.
Script withRemedy(const Script &script, const Remedy &remedy);

/// The parameter of a scene that slows its velocities, and where it may go: the smaller, the more damping.
struct DampRange
{
    std::string parameter;
    double least = 0.0;
    double grid = 0.01; ///< values that are looked at are multiples of it
};

/// The parameter of a scene that counts passes over its sticks in a step, and where it may go.
struct IterationRange
{
    std::string parameter;
    double most = 0.0;
};

/// The steps shorter than `h` frames that are powers of two, down to 2^-12, the longest first.
std::vector<StepSize> shorterSteps(double h);
/// The methods without a limit to their steps, then those that keep them short enough themselves; of each kind the
/// highest order first, and of two alike the later of allMethods().
std::vector<MethodPtr> unlimitedMethods();

/// Shares of the limit that a remedy must reach.
constexpr double safeShare = 0.6;     ///< by a smaller step or another method
constexpr double marginalShare = 0.9; ///< by damping

/// What would mend a step that is past safeShare of its limit, the least change first; each found by measuring it. The
/// step is the largest power of 1/2 a frame, the damping the least, another method the one with the fewest forces
/// computed a step. None where nothing needs mending, and only what really does it.
/// @param values in force, with which `state` came about
/// @param damp null where the scene has no such parameter
std::vector<Remedy> remediesFor(const Script &script, const Values &values, const State &state,
                                const Stability &now, const DampRange *damp);

}
