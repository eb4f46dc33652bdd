#include "sim/effects/constraints/sticks.h"

#include "sim/base/error.h"
#include "sim/scene/blueprint_draft.h"

namespace sim {

namespace {

/// Returns the ends of stick `one` after enforcing it once in `state`.
StickEnds endsOf(const Stick &one, const State &state, DirectionRule directionRule)
{
    const Vec2 a = state.positionOf(one.a), b = state.positionOf(one.b);
    const double share = !state.isDynamic(one.a) ? 0.0 : !state.isDynamic(one.b) ? 1.0 : one.share;
    if (directionRule == DirectionRule::published)
        return publishedStick(a, b, one.length, share);
    return stick(a, b, direction(a - b, one.b, one.a), one.length, share);
}

/// Moves the ends of stick `one` to `ends`. A point at both ends of the same stick moves twice, as in the
/// published code.
void moveEnds(State &state, const Stick &one, const StickEnds &ends)
{
    const Vec2 moveOfB = ends.b - state.positionOf(one.b);
    state.place(one.a, ends.a);
    state.place(one.b, one.a == one.b ? ends.a + moveOfB : ends.b);
}

bool acts(const Stick &one, const State &state)
{
    return state.isDynamic(one.a) || state.isDynamic(one.b);
}

}

Sticks::Sticks(std::vector<Stick> sticks, int points, int iterations)
    : m_sticks(std::move(sticks)), m_iterations(iterations)
{
    for (std::size_t i = 0; i < m_sticks.size(); ++i) {
        for (const int end : {m_sticks[i].a, m_sticks[i].b}) {
            if (end < 0 || end >= points)
                throw Error("stick-without-end", {{"stick", std::to_string(i)},
                                                  {"end", std::to_string(end)},
                                                  {"points", std::to_string(points)}});
        }
    }
}

std::vector<Region> Sticks::regions(DirectionRule directionRule) const
{
    const Region loop = {"sim/effects/constraints/sticks.cpp", "sticks"};
    if (directionRule == DirectionRule::published)
        return {loop, {"sim/effects/constraints/stick.h", "published_stick"}};
    return {loop, {"sim/effects/constraints/stick.h", "stick"}, {"sim/base/direction.h", "direction"}};
}

// Shown lines are short.
// clang-format off
//! [sticks]
template <class Visit>
void Sticks::forEach(
    PointRange points, Visit &&visit) const
{
    for (int i = 0; i < m_iterations; ++i)
        for (const Stick &one : m_sticks)
            if (points.contains(
                    std::max(one.a, one.b)))
                visit(one);
}
//! [sticks]
// clang-format on

int Sticks::count(const State &state, PointRange points) const
{
    int total = 0;
    for (const Stick &one : m_sticks)
        total += points.contains(std::max(one.a, one.b)) && acts(one, state) ? 1 : 0;
    return total;
}

void Sticks::addCouplings(std::vector<Coupling> &into) const
{
    for (const Stick &one : m_sticks)
        into.emplace_back(one.a, one.b);
}

void Sticks::enforce(State &state, PointRange points, DirectionRule directionRule, double) const
{
    forEach(points, [&](const Stick &one) {
        if (acts(one, state))
            moveEnds(state, one, endsOf(one, state, directionRule));
    });
}

std::vector<LiveValue> Sticks::explain(const State &before, const State &after, int point) const
{
    const PointRange all = {0, before.pointCount()};
    for (const DirectionRule directionRule : {DirectionRule::regularised, DirectionRule::published}) {
        State state = before;
        std::vector<LiveValue> values;
        forEach(all, [&](const Stick &one) {
            if (!acts(one, state))
                return;
            const StickEnds ends = endsOf(one, state, directionRule);
            const bool isA = one.a == point;
            if (isA || one.b == point)
                values = {{"distance", ends.distance},
                          {"error", ends.error},
                          {isA ? "a" : "b", isA ? ends.a : ends.b, state.positionOf(point)}};
            moveEnds(state, one, ends);
        });
        if (state.positionOf(point) == after.positionOf(point))
            return values;
    }
    return {}; // `after` comes from a call for only some of the points
}

void Sticks::addRestTargets(const State &state, std::vector<RestTarget> &into) const
{
    for (const Stick &one : m_sticks) {
        into.push_back(restTargetAt(state, one.a, one.b, one.length));
        into.push_back(restTargetAt(state, one.b, one.a, one.length));
    }
}

std::vector<const Sticks *> sticksAmong(const std::vector<EffectPtr> &effects)
{
    std::vector<const Sticks *> found;
    for (const EffectPtr &effect : effects) {
        if (const auto *sticks = dynamic_cast<const Sticks *>(effect.get()))
            found.push_back(sticks);
    }
    return found;
}

bool Sticks::addToDraft(BlueprintDraft &draft) const
{
    for (const Stick &one : m_sticks)
        draft.blueprint.sticks.push_back({one.a, one.b, one.length, one.share});
    draft.parameters["iterations"] = m_iterations;
    return true;
}

namespace {

constexpr ParameterSpec sticksParameters[] = {{
    .id = "iterations",
    .name = SIM_TEXT("Iterations"),
    .unit = SIM_TEXT("passes"),
    .help = SIM_TEXT("How often each frame goes through the list of sticks."),
    .defaultValue = 10.0,
    .min = 1.0,
    .max = 1000.0,
    .sliderMin = 1.0,
    .sliderMax = 50.0,
    .decimals = 0,
    .role = ParameterRole::iterations,
    .isInteger = true,
}};

}

namespace descriptions {
constinit const EffectDescription sticks = {
    .id = "sticks",
    .title = SIM_TEXT("sticks"),
    .kind = EffectKind::stick,
    .purpose =
        SIM_TEXT("Give each pair of points its length back, by moving them: a stick does not stretch."),
    .parameters = sticksParameters};
}

}
