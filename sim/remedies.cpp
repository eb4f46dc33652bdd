#include "sim/remedies.h"

#include "sim/error.h"
#include "sim/methods/methods.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr int mostStrengths = 6;         ///< of shorter steps and more damping: a step of 1/64, say
constexpr double mostWork = 2e7;         ///< of a trial, in phases times points
constexpr double toleranceFactor = 10.0; ///< from one strength to the next
constexpr double mostTolerance = 100.0;  ///< px
constexpr double firstKept = 0.95;       ///< where nothing was damped
constexpr double calm = 1e6;             ///< px: nothing that holds goes farther, unless it was there before
constexpr std::int64_t beyond = 100;     ///< frames past twice the frame of the stop

enum class Trial { holds, fails, takesTooLong };

std::int64_t trialFrames(const Stop &stop)
{
    return 2 * stop.frame + beyond;
}

double farthest(const State &state)
{
    return state.position.size() > 0 ? state.position.abs().maxCoeff() : 0.0;
}

/// Whether a run is finite, and not on its way out, up to `frames`. What grows by a constant factor a frame, and had
/// left all numbers at half of that, would be far out by then even if its rate were a fiftieth.
Trial tried(const Script &script, std::int64_t frames, const GoesOn &goesOn)
{
    Track track(script, 0);
    const double far = std::max(calm, 10.0 * farthest(track.now()));
    double work = 0.0;
    const double each = std::max(1, track.now().points());
    const bool isThere = track.seek({frames, 0}, [&] {
        work += each;
        return work < mostWork && goesOn();
    });
    if (!isThere)
        return Trial::takesTooLong;
    return !track.stop() && farthest(track.now()) < far ? Trial::holds : Trial::fails;
}

bool composes(const Script &script)
{
    try {
        Track::check(script, 0);
    } catch (const Error &) {
        return false;
    }
    return true;
}

Script with(const Script &script, const MethodPtr &method, StepSize step)
{
    Script other = script;
    other.method = method;
    other.step = step;
    return other;
}

/// Smaller and smaller steps.
std::vector<Script> smallerSteps(const Script &script)
{
    std::vector<Script> all;
    double h = script.step.h;
    for (int i = 0; i < mostStrengths && h >= 2e-6; ++i) {
        h = h >= 2.0 ? std::floor(h / 2.0) : h / 2.0;
        all.push_back(with(script, script.method, StepSize::of(h)));
    }
    return all;
}

std::vector<Script> largerTolerances(const Script &script)
{
    std::vector<Script> all;
    double tolerance = toleranceFactor * script.step.tolerance;
    for (; tolerance <= mostTolerance; tolerance *= toleranceFactor)
        all.push_back(with(script, script.method, StepSize::within(tolerance)));
    return all;
}

/// Those whose steps nothing limits: the highest order first, and of two alike the one that lets what is stiff come to
/// rest.
std::vector<Script> otherMethods(const Script &script)
{
    std::vector<MethodPtr> methods = allMethods();
    std::erase_if(methods, [&](const MethodPtr &method) {
        return method->stepLimit() != StepLimit::none || method->id() == script.method->id();
    });
    std::stable_sort(methods.begin(), methods.end(), [](const MethodPtr &a, const MethodPtr &b) {
        return std::pair(-a->order(), a->symplectic()) < std::pair(-b->order(), b->symplectic());
    });
    std::vector<Script> all;
    for (const MethodPtr &method : methods)
        all.push_back(with(script, method, stepFor(*method, script.step)));
    return all;
}

/// What is kept where there is twice as much damping: the square, in hundredths, as sliders have it.
double keptByTwice(double kept, double least)
{
    const double square = kept < 1.0 ? std::max(0.01, std::floor(100.0 * kept * kept) / 100.0) : firstKept;
    return std::min(kept, std::max(least, square));
}

/// Each damps twice as much as the one before.
std::vector<Script> moreDamping(const Script &script, const KeptShare &damping)
{
    std::vector<Script> all;
    Script damped = script;
    for (int i = 0; i < mostStrengths && !damping.id.empty(); ++i) {
        const double before = damped.values[damping.id];
        damped.values.set(damping.id, keptByTwice(before, damping.least));
        for (Event &event : damped.input) {
            Set *set = std::get_if<Set>(&event.what);
            if (set && set->parameter == damping.id)
                set->value = keptByTwice(set->value, damping.least);
        }
        if (damped.values[damping.id] == before)
            break;
        all.push_back(damped);
    }
    return all;
}

/// The first of `scripts` that holds; where none is known to, the first whose trial would take too long.
void addFirst(RemedyKind kind, const std::vector<Script> &scripts, std::int64_t frames, const GoesOn &goesOn,
              std::vector<Remedy> &into)
{
    const Script *untried = nullptr;
    for (const Script &script : scripts) {
        if (!goesOn())
            return;
        if (!composes(script))
            continue;
        const Trial trial = tried(script, frames, goesOn);
        if (trial == Trial::holds) {
            into.push_back({kind, script, frames});
            return;
        }
        if (trial == Trial::takesTooLong && !untried)
            untried = &script;
    }
    if (untried && goesOn())
        into.push_back({kind, *untried, 0});
}

}

std::vector<Remedy> remediesFor(const Script &script, const Stop &stop, const KeptShare &damping,
                                const GoesOn &goesOn)
{
    std::vector<Remedy> all;
    const std::int64_t frames = trialFrames(stop);
    if (!script.step.adaptive())
        addFirst(RemedyKind::smallerStep, smallerSteps(script), frames, goesOn, all);
    else if (stop.reason == StopReason::tooManySteps)
        addFirst(RemedyKind::largerTolerance, largerTolerances(script), frames, goesOn, all);
    addFirst(RemedyKind::otherMethod, otherMethods(script), frames, goesOn, all);
    addFirst(RemedyKind::moreDamping, moreDamping(script, damping), frames, goesOn, all);
    return all;
}

}
