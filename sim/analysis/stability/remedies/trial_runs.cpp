#include "sim/analysis/stability/remedies/trial_runs.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr int maxDampings = 6;           ///< each twice the previous one
constexpr double maxTrialWork = 2e7;     ///< per trial: points times phases, plus force evaluations
constexpr double toleranceFactor = 10.0; ///< from one tolerance to the next
constexpr double maxTolerance = 100.0;   ///< px
constexpr double firstKeptPart = 0.95;   ///< of a velocity, when there was no damping
/// px, from the origin; a stable run stays closer unless it starts farther out.
constexpr double maxDistance = 1e6;
constexpr double maxSpeedRatio = 10.0; ///< a stable run moves at most this many times its extent per frame
/// px, about the extent of the view; for scenes that start at one position.
constexpr double minExtent = 500.0;
constexpr std::int64_t framesAfterStop = 50; ///< how long a trial run continues after the frame of the stop

enum class Trial { stable, unstable, tooLong };

double farthest(const State &state)
{
    return state.position.size() > 0 ? state.position.abs().maxCoeff() : 0.0;
}

double fastest(const State &state)
{
    return state.velocity.size() > 0 ? state.velocity.abs().maxCoeff() : 0.0;
}

/// Returns whether a run stays finite and bounded for `frames` frames. A step that is slightly too long can
/// leave radial springs tumbling at high speed without growing or settling. That counts as failure.
/// maxDistance is chosen to detect slow growth. The run that stopped had grown by up to e^709, the largest
/// double. Growth at a fiftieth of that rate reaches e^14, about 10^6.
Trial runTrial(const Script &script, std::int64_t frames, const ShouldContinue &shouldContinue)
try {
    Track track(script, 0);
    const double distanceLimit = std::max(maxDistance, 10.0 * farthest(track.state()));
    const double speedLimit =
        maxSpeedRatio * std::max({minExtent, farthest(track.state()), fastest(track.state())});
    const double points = std::max(1, track.state().pointCount());
    double phases = 0.0;
    const bool isReached = track.seek({frames, 0}, [&] {
        phases += 1.0;
        const double forces = static_cast<double>(track.state().pointEvaluations);
        return points * phases + forces < maxTrialWork && shouldContinue();
    });
    if (!isReached)
        return Trial::tooLong;
    const bool isBounded = farthest(track.state()) < distanceLimit && fastest(track.state()) < speedLimit;
    return !track.stop() && isBounded ? Trial::stable : Trial::unstable;
} catch (const Error &) {
    return Trial::unstable; // the script does not compose
}

std::vector<Remedy> withSmallerSteps(const Script &script)
{
    std::vector<Remedy> all;
    for (const StepSize step : shorterSteps(script.step.h))
        all.push_back(Remedy::of(Remedy::Kind::smallerStep, script.method, step));
    return all;
}

std::vector<Remedy> largerTolerances(const Script &script)
{
    std::vector<Remedy> all;
    double tolerance = toleranceFactor * script.step.tolerance;
    for (; tolerance <= maxTolerance; tolerance *= toleranceFactor)
        all.push_back(
            Remedy::of(Remedy::Kind::largerTolerance, script.method, StepSize::withTolerance(tolerance)));
    return all;
}

std::vector<Remedy> otherMethods(const Script &script)
{
    std::vector<Remedy> all;
    for (const MethodPtr &method : unlimitedMethods()) {
        if (method->id() != script.method->id())
            all.push_back(Remedy::of(Remedy::Kind::unlimitedMethod, method, stepFor(*method, script.step)));
    }
    return all;
}

/// Returns the largest value of the parameter during the run.
double maxValueOf(const std::string &parameter, const Script &script)
{
    double largest = script.values[parameter];
    for (const Event &event : script.input) {
        const Set *set = std::get_if<Set>(&event.what);
        if (set && set->parameter == parameter)
            largest = std::max(largest, set->value);
    }
    return largest;
}

/// Returns the kept part of a velocity with twice the damping: the square, rounded to the grid of the slider.
double keptAtTwiceDamping(double kept, const DampRange &range)
{
    const double square = kept < 1.0 ? kept * kept : firstKeptPart;
    const double gridded = range.grid * std::max(1.0, std::floor(square / range.grid));
    return std::max(range.least, std::round(gridded * 1e9) / 1e9);
}

/// Returns remedies that each double the damping of the previous one.
std::vector<Remedy> moreDamping(const Script &script, const DampRange &range)
{
    std::vector<Remedy> all;
    double kept = maxValueOf(range.parameter, script);
    for (int i = 0; i < maxDampings; ++i) {
        const double next = keptAtTwiceDamping(kept, range);
        if (next >= kept)
            break;
        kept = next;
        all.push_back(Remedy::of(Remedy::Kind::moreDamping, script.method, script.step));
        all.back().parameter = range.parameter;
        all.back().value = kept;
    }
    return all;
}

/// Adds the first of `remedies` that does not fail: it is stable, or its trial would take too long.
void addFirst(const std::vector<Remedy> &remedies, const Script &script, std::int64_t frames,
              const ShouldContinue &shouldContinue, std::vector<Remedy> &found)
{
    for (const Remedy &remedy : remedies) {
        const Trial trial = runTrial(withRemedy(script, remedy), frames, shouldContinue);
        if (!shouldContinue())
            return;
        if (trial == Trial::unstable)
            continue;
        found.push_back(remedy);
        found.back().stableFrames = trial == Trial::stable ? frames : 0;
        return;
    }
}

}

std::vector<Remedy> remediesAfter(const Script &script, const Stop &stop, const DampRange *damp,
                                  const ShouldContinue &shouldContinue)
{
    std::vector<Remedy> all;
    const std::int64_t frames = stop.frame + framesAfterStop;
    if (!script.step.isAdaptive())
        addFirst(withSmallerSteps(script), script, frames, shouldContinue, all);
    else if (stop.reason == StopReason::tooManySteps)
        addFirst(largerTolerances(script), script, frames, shouldContinue, all);
    if (damp)
        addFirst(moreDamping(script, *damp), script, frames, shouldContinue, all);
    addFirst(otherMethods(script), script, frames, shouldContinue, all);
    return all;
}

}
