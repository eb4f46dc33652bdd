#pragma once

#include "sim/base/error.h"
#include "sim/run/script/script.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A method with its step or tolerance.
struct MethodSetup
{
    MethodPtr method;
    StepSize step;
};

/// The result of measuring one method setup.
enum class Outcome {
    waiting,    ///< not tried yet
    measured,   ///< its error is known (and its time, once nsPerFrame is above 0)
    unstable,   ///< the run diverged, or its numbers stopped being finite
    doesNotFit, ///< the method cannot compute the scene: see AccuracyRow::why
    tooLong,    ///< it would take longer than the plan allows
};

/// One point of the work-precision plot.
struct AccuracyRow
{
    MethodSetup setup;
    Outcome outcome = Outcome::waiting;
    std::optional<Error> why; ///< the reason, for doesNotFit
    /// px, largest distance of any point from the reference at any whole frame up to the horizon.
    double error = 0.0;
    std::vector<double> errorAt; ///< px, at each whole frame from 0 to the horizon
    double evaluations = 0.0;    ///< evaluations of all forces per frame
    double firstRun = 0.0;       ///< ns per frame, of the run that measured the error; 0: there was none
    double nsPerFrame = 0.0;     ///< median of the timed runs; 0: not timed
    double spread = 0.0;         ///< ns per frame, half the distance between the quartiles of the timed runs
    bool front = false;          ///< whether no other measured row is both cheaper and at least as accurate
};

/// The run that errors are measured against.
struct ReferenceRun
{
    /// Errors are distances to the continuous solution of the scene. A scene without one compares each method
    /// with a finer step of the same method.
    enum class Kind { solution, selfRefinement };
    Kind kind = Kind::solution;
    EffectPtr discontinuity; ///< for selfRefinement: the effect that has no continuous limit
    std::string method;      ///< id, or "own_refinement" for selfRefinement
    StepSize step;
    std::string check; ///< id of a second, different method, or "own_refinement" for selfRefinement
    StepSize checkStep;
    double disagreement = 0.0; ///< px, largest distance between reference and check up to the horizon
    /// The reason why the horizon is not later.
    enum class End {
        span,      ///< the horizon is the end of the span
        diverged,  ///< reference and check are too far apart after the horizon
        notFinite, ///< reference or check stops being finite after the horizon
        tooLong,   ///< a later horizon would take too long
    };
    End end = End::span;
    /// px, position of each point at each whole frame from 0 on. Empty for selfRefinement.
    std::vector<std::vector<Vec2>> trajectories;
};

/// Errors and times of many method setups on one scene.
struct Accuracy
{
    std::int64_t span = 0;    ///< frames requested
    std::int64_t horizon = 0; ///< frames up to which the reference is valid and errors are given
    /// Above 0 while the reference is still being computed: errors are a preview over this many frames.
    std::int64_t previewed = 0;
    ReferenceRun reference;
    std::vector<AccuracyRow> rows; ///< by method, in the order of allMethods(), each from coarse to fine
    /// Median over all rows of spread / nsPerFrame. Above 0.1 other programs disturb the timing.
    double noise = 0.0;

    bool noisy() const { return noise > 0.1; }
    /// Returns the number of frames over which the errors of the rows are given.
    std::int64_t framesCompared() const { return previewed > 0 ? previewed : horizon; }
    /// Returns whether no method has any error, as in a scene that does not move without input.
    bool isExact() const;
    /// Returns the cheapest measured row with an error of at most `error` px, or null.
    const AccuracyRow *cheapest(double error) const;
};

/// The extent of a study and its time limits.
struct StudyPlan
{
    std::int64_t frames = 200;
    /// The setup in use, measured besides the refinement levels of all methods.
    std::optional<MethodSetup> inUse;
    double secondsPerRun = 0.5;     ///< setups that would take longer are left out
    double secondsOfTiming = 4.0;   ///< for all timed runs together
    int leastRuns = 5;              ///< timed runs per setup, interleaved
    double secondsToPreview = 0.25; ///< a reference that takes longer gets a preview
};

/// Reports the progress of a study: `done` goes from 0 to 1. Returns false to stop the study.
using StudyProgress = std::function<bool(const Accuracy &soFar, double done)>;

/// The largest number of points of a scene that can be studied, because every method computes it many times.
constexpr int maxStudiedPoints = 20'000;

/// Measures every method on the scene of `script`, with its input, from frame 0 on. It first computes the
/// reference and its horizon, with previews if that takes long. Then it measures the error of each setup from
/// coarse to fine, and last the times, by interleaved runs. May run on any thread. A stopped study returns
/// what it has measured.
/// @throws Error when the script's method cannot compute the scene; "too-many-points" (points, most) when the
/// scene starts with more than maxStudiedPoints
Accuracy studyAccuracy(const Script &script, const StudyPlan &plan, const StudyProgress &progress);

/// Returns the steps (1, 1/2, 1/4, ...) or tolerances that a study tries for `method`, from coarse to fine.
std::vector<StepSize> refinementLevels(const Method &method);

/// Sets AccuracyRow::front of each row: the Pareto front of error and time.
void markFront(std::vector<AccuracyRow> &rows);

}
