#include "sim/stability/remedies.h"

#include "sim/error.h"
#include "sim/methods/methods.h"

#include <cmath>
#include <optional>

namespace sim {

namespace {

constexpr int mostHalvings = 12;

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
    for (int i = 0; i <= mostHalvings; ++i) {
        const double h = std::ldexp(1.0, -i);
        if (h >= now.h || h > wellHeld * now.limit)
            continue;
        found.step = StepSize::of(h);
        found.share = h / now.limit;
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
    if (!reaches(best, justHeld))
        return {};
    while (grown - held > 1) {
        const int middle = (held + grown) / 2;
        const Stability found = withDamping(about, range.parameter, gridded(middle));
        if (reaches(found, justHeld)) {
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
            !method->needs().empty() || !fits(about, *method, step))
            continue;
        const Stability found =
            stabilityOf(sceneOf(about.script, about.values), about.state, *method, step.h);
        if (!reaches(found, wellHeld))
            continue;
        const bool better =
            !best || method->evaluations() < best->method->evaluations() ||
            (method->evaluations() == best->method->evaluations() && found.share() < best->share - 1e-9);
        if (better)
            best = Remedy{Remedy::Kind::holdingMethod, method, step, 0.0, found.share()};
    }
    return best;
}

/// The one of highest order that goes with the scene; of those with steps before those with a tolerance.
std::optional<Remedy> boundlessMethod(const Case &about)
{
    std::optional<Remedy> best;
    for (const StepLimit limit : {StepLimit::none, StepLimit::tolerance}) {
        for (const MethodPtr &method : allMethods()) {
            const StepSize step = stepFor(*method, about.script.step);
            if (method->stepLimit() == limit && (!best || method->order() >= best->method->order()) &&
                fits(about, *method, step))
                best = Remedy{Remedy::Kind::boundlessMethod, method, step, 0.0, 0.0};
        }
        if (best)
            return best;
    }
    return best;
}

}

std::vector<Remedy> remediesFor(const Script &script, const Values &values, const State &state,
                                const Stability &now, const DampRange *damp)
{
    std::vector<Remedy> found;
    if (now.bound != Bound::stiffness || reaches(now, wellHeld))
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
