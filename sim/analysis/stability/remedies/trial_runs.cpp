#include "sim/analysis/stability/remedies/trial_runs.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr int mostDampings = 6;          ///< each twice the one before
constexpr double mostWork = 2e7;         ///< of a trial: phases and computed forces, times points
constexpr double toleranceFactor = 10.0; ///< from one to the next
constexpr double mostTolerance = 100.0;  ///< px
constexpr double firstKept = 0.95;       ///< where nothing was damped
constexpr double calm = 1e6;             ///< px: nothing that holds goes farther, unless it was there before
constexpr double hurry = 10.0;           ///< what holds is not faster than so many times its extent a frame
constexpr double leastExtent = 500.0;    ///< px: about a picture's, also of what begins in one place
constexpr std::int64_t beyond = 50;      ///< frames past that of the stop

enum class Trial { holds, fails, takesTooLong };

double farthest(const State &state)
{
    return state.position.size() > 0 ? state.position.abs().maxCoeff() : 0.0;
}

double fastest(const State &state)
{
    return state.velocity.size() > 0 ? state.velocity.abs().maxCoeff() : 0.0;
}

/// Whether a run is finite, calm, and not on its way out, up to `frames`. A step that is a little too long may leave
/// radial springs tumbling about at great speed, never farther out and never still: that holds nothing. What grows by a
/// constant factor a frame, and had left all numbers by then, would be 10^6 times as far out even if its rate were a
/// fiftieth: the logarithm of the largest number is 709.
Trial tried(const Script &script, std::int64_t frames, const ShouldContinue &shouldContinue)
try {
    Track track(script, 0);
    const double far = std::max(calm, 10.0 * farthest(track.state()));
    const double fast = hurry * std::max({leastExtent, farthest(track.state()), fastest(track.state())});
    const double points = std::max(1, track.state().pointCount());
    double phases = 0.0;
    const bool isThere = track.seek({frames, 0}, [&] {
        phases += 1.0;
        const double forces = static_cast<double>(track.state().pointEvaluations);
        return points * phases + forces < mostWork && shouldContinue();
    });
    if (!isThere)
        return Trial::takesTooLong;
    const bool isCalm = farthest(track.state()) < far && fastest(track.state()) < fast;
    return !track.stop() && isCalm ? Trial::holds : Trial::fails;
} catch (const Error &) {
    return Trial::fails; // it does not compose
}

std::vector<Remedy> smallerSteps(const Script &script)
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
    for (; tolerance <= mostTolerance; tolerance *= toleranceFactor)
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

/// The largest value that the parameter has on the way.
double mostOf(const std::string &parameter, const Script &script)
{
    double most = script.values[parameter];
    for (const Event &event : script.input) {
        const Set *set = std::get_if<Set>(&event.what);
        if (set && set->parameter == parameter)
            most = std::max(most, set->value);
    }
    return most;
}

/// What is kept where there is twice as much damping: the square, as the slider has it.
double keptByTwice(double kept, const DampRange &range)
{
    const double square = kept < 1.0 ? kept * kept : firstKept;
    const double gridded = range.grid * std::max(1.0, std::floor(square / range.grid));
    return std::max(range.least, std::round(gridded * 1e9) / 1e9);
}

/// Each damps twice as much as the one before.
std::vector<Remedy> moreDamping(const Script &script, const DampRange &range)
{
    std::vector<Remedy> all;
    double kept = mostOf(range.parameter, script);
    for (int i = 0; i < mostDampings; ++i) {
        const double less = keptByTwice(kept, range);
        if (less >= kept)
            break;
        kept = less;
        all.push_back(Remedy::of(Remedy::Kind::moreDamping, script.method, script.step));
        all.back().parameter = range.parameter;
        all.back().value = kept;
    }
    return all;
}

/// The first of `remedies` that is not known to fail: one that holds, or whose trial would take too long.
void addFirst(const std::vector<Remedy> &remedies, const Script &script, std::int64_t frames,
              const ShouldContinue &shouldContinue, std::vector<Remedy> &into)
{
    for (const Remedy &one : remedies) {
        const Trial trial = tried(withRemedy(script, one), frames, shouldContinue);
        if (!shouldContinue())
            return;
        if (trial == Trial::fails)
            continue;
        into.push_back(one);
        into.back().stableFrames = trial == Trial::holds ? frames : 0;
        return;
    }
}

}

std::vector<Remedy> remediesAfter(const Script &script, const Stop &stop, const DampRange *damp,
                                  const ShouldContinue &shouldContinue)
{
    std::vector<Remedy> all;
    const std::int64_t frames = stop.frame + beyond;
    if (!script.step.isAdaptive())
        addFirst(smallerSteps(script), script, frames, shouldContinue, all);
    else if (stop.reason == StopReason::tooManySteps)
        addFirst(largerTolerances(script), script, frames, shouldContinue, all);
    if (damp)
        addFirst(moreDamping(script, *damp), script, frames, shouldContinue, all);
    addFirst(otherMethods(script), script, frames, shouldContinue, all);
    return all;
}

}
