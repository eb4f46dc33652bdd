#pragma once

#include "sim/base/error.h"
#include "sim/run/script/script.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// One way of computing a scene: a method, and its step or tolerance.
struct MethodSetup
{
    MethodPtr method;
    StepSize step;
};

/// What came of one way of computing a scene.
enum class Outcome {
    waiting,    ///< not tried yet
    measured,   ///< its error is known (and its time, once nsPerFrame is above 0)
    unstable,   ///< its numbers grew without bound, or stopped being finite
    doesNotFit, ///< the method cannot compute the scene: see AccuracyRow::why
    tooLong,    ///< it would take longer than the plan allows
};

/// One point of the work-precision plot.
struct AccuracyRow
{
    MethodSetup setup;
    Outcome outcome = Outcome::waiting;
    std::optional<Error> why; ///< for doesNotFit
    double error = 0.0;       ///< px, the largest distance of any body at any whole frame up to the horizon
    std::vector<double> errorAt; ///< px, at each whole frame from 0 to the horizon
    double evaluations = 0.0;    ///< how often it computes all forces, a frame
    double firstRun = 0.0;       ///< ns a frame, of the run that told the error; 0: there was none
    double nsPerFrame = 0.0;     ///< the median of the repeated runs; 0: not timed
    double spread = 0.0;         ///< ns, half of the distance between the quartiles of the runs
    bool front = false;          ///< nothing that was measured is at least as exact and cheaper
};

/// What errors are measured against.
struct ReferenceRun
{
    /// What it is compared with: the scene's continuous solution, or (where it has none) each method's own finer
    /// step.
    enum class Kind { solution, selfRefinement };
    Kind kind = Kind::solution;
    EffectPtr discontinuity; ///< for selfRefinement: the effect that has no continuous limit
    std::string method;      ///< its id; for selfRefinement: "own_refinement"
    StepSize step;
    std::string check; ///< id of the second, unlike method; for selfRefinement: "own_refinement"
    StepSize checkStep;
    double disagreement = 0.0; ///< px, the largest distance between the two up to the horizon
    /// Why the horizon is where it is.
    enum class End {
        span,      ///< it is the end of the span
        diverged,  ///< the two are too far apart after it
        notFinite, ///< one of them stops being finite after it
        tooLong,   ///< going on would take too long
    };
    End end = End::span;
    /// Where each point is at each whole frame from 0 on. Empty for selfRefinement.
    std::vector<std::vector<Vec2>> trajectories;
};

/// How errors and times of many ways compare on one scene.
struct Accuracy
{
    std::int64_t span = 0;    ///< frames that were asked for
    std::int64_t horizon = 0; ///< frames up to which the reference holds; errors are given up to it
    /// Above 0: the reference is still under way, and the errors of rows are a first look over so many frames.
    std::int64_t previewed = 0;
    ReferenceRun reference;
    std::vector<AccuracyRow> rows; ///< by method, in the order of allMethods(), each from coarse to fine
    /// The share of its median by which a typical row's runs differ: above 0.1 the machine is busy with other things.
    double noise = 0.0;

    bool noisy() const { return noise > 0.1; }
    /// Frames over which the errors of rows are given.
    std::int64_t framesCompared() const { return previewed > 0 ? previewed : horizon; }
    /// Whether no method is off at all, as where nothing moves until somebody does something.
    bool isExact() const;
    /// The cheapest measured row with an error of at most `error` px, or null.
    const AccuracyRow *cheapest(double error) const;
};

/// What a study is to do.
struct StudyPlan
{
    std::int64_t frames = 200;
    /// Besides the ladder of every method: the way in use, if it is not a rung already.
    std::optional<MethodSetup> inUse;
    double secondsPerRun = 0.5;     ///< rungs that would take longer are left out
    double secondsOfTiming = 4.0;   ///< of all repeated runs together
    int leastRuns = 5;              ///< of each rung, interleaved
    double secondsToPreview = 0.25; ///< a reference that takes longer is looked at before it is done
};

/// Tells how far a study is: `done` from 0 to 1. Returns false to stop it.
using StudyProgress = std::function<bool(const Accuracy &soFar, double done)>;

/// The most points of a scene that is studied: every method computes it, many times over.
constexpr int maxStudiedPoints = 20'000;

/// Measures every method on the scene of `script`, with its input, from frame 0 on: first the reference and its
/// horizon (where that takes long, with a first look at errors up to where it has come), then each rung's error
/// from coarse to fine, then times by interleaved runs. May run on any thread; a study that is stopped returns what
/// it has.
/// @throws Error when the scene cannot be computed by the script's own method; "too-many-points" (points, most) when
/// its start has more than mostStudied
Accuracy studyAccuracy(const Script &script, const StudyPlan &plan, const StudyProgress &progress);

/// The rungs that a study tries for `method`: steps 1, 1/2, 1/4... or tolerances, from coarse to fine.
std::vector<StepSize> refinementLevels(const Method &method);

/// Marks the rows that nothing beats.
void markFront(std::vector<AccuracyRow> &rows);

}
