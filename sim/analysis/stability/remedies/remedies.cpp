#include "sim/analysis/stability/remedies/remedies.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {

namespace {

constexpr int longestStep = 6;    ///< a power of two, in frames
constexpr int shortestStep = -12; ///< likewise

/// What is asked about each time.
struct Case
{
    const Script &script;
    const Values &values;
    const State &state;
};

bool reaches(const Stability &found, double share)
{
    return found.holds() && found.share() <= share;
}

std::optional<Remedy> smallerStep(const Case &about, const Stability &now)
{
    Remedy found;
    found.kind = Remedy::Kind::smallerStep;
    found.method = about.script.method;
    for (const StepSize step : shorterSteps(now.h)) {
        if (step.h > safeShare * now.limit)
            continue;
        found.step = step;
        found.share = step.h / now.limit;
        return found;
    }
    return {};
}

Stability withDamping(const Case &about, const std::string &parameter, double value)
{
    Values values = about.values;
    values.set(parameter, value);
    return stabilityOf(sceneOf(about.script, values), about.state, *about.script.method, about.script.step.h);
}

std::optional<Remedy> moreDamping(const Case &about, const DampRange &range)
{
    // The more damping, the farther the limit: so the least that reaches it can be found by halving.
    const auto gridded = [&](int i) { return std::round(i * range.grid * 1e9) / 1e9; };
    int held = static_cast<int>(std::ceil(range.least / range.grid - 1e-9));
    int grown = static_cast<int>(std::ceil(about.values[range.parameter] / range.grid - 1e-9));
    if (held >= grown)
        return {};
    Stability best = withDamping(about, range.parameter, gridded(held));
    if (!reaches(best, marginalShare))
        return {};
    while (grown - held > 1) {
        const int middle = (held + grown) / 2;
        const Stability found = withDamping(about, range.parameter, gridded(middle));
        if (reaches(found, marginalShare)) {
            held = middle;
            best = found;
        } else {
            grown = middle;
        }
    }
    Remedy found;
    found.kind = Remedy::Kind::moreDamping;
    found.method = about.script.method;
    found.step = about.script.step;
    found.parameter = range.parameter;
    found.value = gridded(held);
    found.share = best.share();
    return found;
}

bool fits(const Case &about, const Method &method, StepSize step)
{
    try {
        Script script = about.script;
        script.method = findMethod(method.id());
        compose(sceneOf(script, about.values), method, step);
        return true;
    } catch (const Error &) {
        return false;
    }
}

std::optional<Remedy> holdingMethod(const Case &about)
{
    std::optional<Remedy> best;
    const StepSize step = about.script.step;
    for (const MethodPtr &method : allMethods()) {
        if (method->stepLimit() != StepLimit::stiffness || method->id() == about.script.method->id() ||
            !method->requirements().empty() || !fits(about, *method, step))
            continue;
        const Stability found =
            stabilityOf(sceneOf(about.script, about.values), about.state, *method, step.h);
        if (!reaches(found, safeShare))
            continue;
        const bool better = !best || method->evaluationsPerStep() < best->method->evaluationsPerStep() ||
                            (method->evaluationsPerStep() == best->method->evaluationsPerStep() &&
                             found.share() < best->share - 1e-9);
        if (better)
            best = Remedy::of(Remedy::Kind::stableMethod, method, step, found.share());
    }
    return best;
}

std::optional<Remedy> boundlessMethod(const Case &about)
{
    for (const MethodPtr &method : unlimitedMethods()) {
        const StepSize step = stepFor(*method, about.script.step);
        if (fits(about, *method, step))
            return Remedy::of(Remedy::Kind::unlimitedMethod, method, step);
    }
    return {};
}

}

Remedy Remedy::of(Kind kind, const MethodPtr &method, StepSize step, double share)
{
    Remedy one;
    one.kind = kind;
    one.method = method;
    one.step = step;
    one.share = share;
    return one;
}

std::vector<StepSize> shorterSteps(double h)
{
    std::vector<StepSize> steps;
    for (int power = longestStep; power >= shortestStep; --power) {
        if (std::ldexp(1.0, power) < h)
            steps.push_back(StepSize::ofLength(std::ldexp(1.0, power)));
    }
    return steps;
}

std::vector<MethodPtr> unlimitedMethods()
{
    std::vector<MethodPtr> methods = allMethods();
    std::erase_if(methods,
                  [](const MethodPtr &method) { return method->stepLimit() == StepLimit::stiffness; });
    std::reverse(methods.begin(), methods.end());
    std::stable_sort(methods.begin(), methods.end(), [](const MethodPtr &a, const MethodPtr &b) {
        const auto rank = [](const MethodPtr &method) {
            return std::pair(method->stepLimit() == StepLimit::none ? 0 : 1, -method->order());
        };
        return rank(a) < rank(b);
    });
    return methods;
}

Script withRemedy(const Script &script, const Remedy &remedy)
{
    Script other = script;
    if (!remedy.setsParameter()) {
        other.method = remedy.method;
        other.step = remedy.step;
        return other;
    }
    // What is kept of a speed is less where more is damped; of passes there are more.
    const auto changed = [&](double value) {
        return remedy.kind == Remedy::Kind::moreDamping ? std::min(value, remedy.value)
                                                        : std::max(value, remedy.value);
    };
    other.values.set(remedy.parameter, changed(other.values[remedy.parameter]));
    for (Event &event : other.input) {
        Set *set = std::get_if<Set>(&event.what);
        if (set && set->parameter == remedy.parameter)
            set->value = changed(set->value);
    }
    return other;
}

std::vector<Remedy> remediesFor(const Script &script, const Values &values, const State &state,
                                const Stability &now, const DampRange *damp)
{
    std::vector<Remedy> found;
    if (now.bound != Bound::stiffness || reaches(now, safeShare))
        return found;
    const Case about{script, values, state};
    const auto take = [&](const std::optional<Remedy> &one) {
        if (one)
            found.push_back(*one);
    };
    take(smallerStep(about, now));
    if (damp)
        take(moreDamping(about, *damp));
    take(holdingMethod(about));
    take(boundlessMethod(about));
    return found;
}

}
