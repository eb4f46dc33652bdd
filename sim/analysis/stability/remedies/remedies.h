#pragma once

#include "sim/analysis/stability/stability.h"
#include "sim/run/script/script.h"

#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A change to a run that makes it stable or its sticks fit.
struct Remedy
{
    enum class Kind {
        smallerStep,     ///< the same method at `step`
        largerTolerance, ///< the same method at `step`, with a larger tolerance
        moreDamping,     ///< `parameter` at `value`
        moreIterations,  ///< `parameter` at `value`
        stableMethod,    ///< another method with a sufficient limit at the same step
        unlimitedMethod, ///< another method without a stability limit
    };
    Kind kind = Kind::smallerStep;
    MethodPtr method;
    StepSize step;
    double value = 0.0;
    /// Step divided by the limit, after the change; 0 if there is no limit or it was not computed.
    double share = 0.0;
    std::string parameter;
    /// Frames of a trial run that stayed stable with the change; 0 without a trial.
    std::int64_t stableFrames = 0;
    /// px, the largest stick error that remains; empty for remedies of instability.
    std::optional<double> stickError = {};

    /// Returns whether the remedy changes a parameter, not the method or step.
    bool setsParameter() const { return kind == Kind::moreDamping || kind == Kind::moreIterations; }
    /// Returns a remedy that changes method or step.
    static Remedy of(Kind kind, const MethodPtr &method, StepSize step, double share = 0.0);
};

/// Returns `script` with the change from its start on. The learner's input stays the same. Only events that
/// set the same parameter to less damping or fewer iterations set the remedy's value instead.
Script withRemedy(const Script &script, const Remedy &remedy);

/// The parameter of a scene that sets which part of a velocity is kept, and its range. Smaller values damp
/// more.
struct DampRange
{
    std::string parameter;
    double least = 0.0; ///< smallest value
    double grid = 0.01; ///< candidates are multiples of it
};

/// The parameter of a scene that sets the iterations over its sticks per step, and its range.
struct IterationRange
{
    std::string parameter;
    double most = 0.0; ///< largest value
};

/// Returns the powers of two shorter than `h` frames, from 2^6 down to 2^-12.
std::vector<StepSize> shorterSteps(double h);
/// Returns the methods without a stability limit, then those that adapt their steps. Both groups start with
/// the highest order. Of methods of equal order, the later one in allMethods() comes first.
std::vector<MethodPtr> unlimitedMethods();

constexpr double safeShare = 0.6;     ///< largest share of the limit with a smaller step or another method
constexpr double marginalShare = 0.9; ///< largest share of the limit with more damping

/// Returns remedies for a step beyond safeShare of its limit, the smallest change first. Each is confirmed by
/// computing its stability. The step is the largest sufficient power of two, the damping the least. The other
/// method is the one with the fewest force evaluations per step. Empty if the step needs no remedy.
/// @param values parameter values in force at `state`
/// @param damp null if the scene has no such parameter
std::vector<Remedy> remediesFor(const Script &script, const Values &values, const State &state,
                                const Stability &now, const DampRange *damp);

}
