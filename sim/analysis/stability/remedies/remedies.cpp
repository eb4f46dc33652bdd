#include "sim/analysis/stability/remedies/remedies.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {

namespace {

constexpr int maxPower = 6;   ///< of two, in frames
constexpr int minPower = -12; ///< of two, in frames

/// The run that needs a remedy.
struct Case
{
    const Script &script;
    const Values &values;
    const State &state;
};

bool isWithin(const Stability &found, double share)
{
    return found.holds() && found.share() <= share;
}

std::optional<Remedy> smallerStep(const Case &context, const Stability &now)
{
    Remedy found;
    found.kind = Remedy::Kind::smallerStep;
    found.method = context.script.method;
    for (const StepSize step : shorterSteps(now.h)) {
        if (step.h > safeShare * now.limit)
            continue;
        found.step = step;
        found.share = step.h / now.limit;
        return found;
    }
    return {};
}

Stability withDamping(const Case &context, const std::string &parameter, double value)
{
    Values values = context.values;
    values.set(parameter, value);
    return stabilityOf(sceneOf(context.script, values), context.state, *context.script.method,
                       context.script.step.h);
}

std::optional<Remedy> moreDamping(const Case &context, const DampRange &range)
{
    // More damping raises the limit, so bisection finds the least damping that is sufficient.
    const auto gridded = [&](int i) { return std::round(i * range.grid * 1e9) / 1e9; };
    int sufficient = static_cast<int>(std::ceil(range.least / range.grid - 1e-9));
    int insufficient = static_cast<int>(std::ceil(context.values[range.parameter] / range.grid - 1e-9));
    if (sufficient >= insufficient)
        return {};
    Stability best = withDamping(context, range.parameter, gridded(sufficient));
    if (!isWithin(best, marginalShare))
        return {};
    while (insufficient - sufficient > 1) {
        const int middle = (sufficient + insufficient) / 2;
        const Stability found = withDamping(context, range.parameter, gridded(middle));
        if (isWithin(found, marginalShare)) {
            sufficient = middle;
            best = found;
        } else {
            insufficient = middle;
        }
    }
    Remedy found;
    found.kind = Remedy::Kind::moreDamping;
    found.method = context.script.method;
    found.step = context.script.step;
    found.parameter = range.parameter;
    found.value = gridded(sufficient);
    found.share = best.share();
    return found;
}

bool fits(const Case &context, const Method &method, StepSize step)
{
    try {
        Script script = context.script;
        script.method = findMethod(method.id());
        compose(sceneOf(script, context.values), method, step);
        return true;
    } catch (const Error &) {
        return false;
    }
}

std::optional<Remedy> stableMethod(const Case &context)
{
    std::optional<Remedy> best;
    const StepSize step = context.script.step;
    for (const MethodPtr &method : allMethods()) {
        if (method->stepLimit() != StepLimit::stiffness || method->id() == context.script.method->id() ||
            !method->requirements().empty() || !fits(context, *method, step))
            continue;
        const Stability found =
            stabilityOf(sceneOf(context.script, context.values), context.state, *method, step.h);
        if (!isWithin(found, safeShare))
            continue;
        const bool better = !best || method->evaluationsPerStep() < best->method->evaluationsPerStep() ||
                            (method->evaluationsPerStep() == best->method->evaluationsPerStep() &&
                             found.share() < best->share - 1e-9);
        if (better)
            best = Remedy::of(Remedy::Kind::stableMethod, method, step, found.share());
    }
    return best;
}

std::optional<Remedy> unlimitedMethod(const Case &context)
{
    for (const MethodPtr &method : unlimitedMethods()) {
        const StepSize step = stepFor(*method, context.script.step);
        if (fits(context, *method, step))
            return Remedy::of(Remedy::Kind::unlimitedMethod, method, step);
    }
    return {};
}

}

Remedy Remedy::of(Kind kind, const MethodPtr &method, StepSize step, double share)
{
    Remedy remedy;
    remedy.kind = kind;
    remedy.method = method;
    remedy.step = step;
    remedy.share = share;
    return remedy;
}

std::vector<StepSize> shorterSteps(double h)
{
    std::vector<StepSize> steps;
    for (int power = maxPower; power >= minPower; --power) {
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
    // A smaller kept part of the velocity damps more; more iterations are a larger number.
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
    if (now.bound != Bound::stiffness || isWithin(now, safeShare))
        return found;
    const Case context{script, values, state};
    const auto addIfAny = [&](const std::optional<Remedy> &remedy) {
        if (remedy)
            found.push_back(*remedy);
    };
    addIfAny(smallerStep(context, now));
    if (damp)
        addIfAny(moreDamping(context, *damp));
    addIfAny(stableMethod(context));
    addIfAny(unlimitedMethod(context));
    return found;
}

}
