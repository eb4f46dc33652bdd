#include "sim/joined.h"

#include "sim/effects/damping.h"
#include "sim/effects/ground.h"
#include "sim/free_points.h"
#include "sim/methods/parts.h"

#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace sim {

namespace {

using Work = std::function<void(State &, Points)>;

/// One point on its way through rules.
struct PointNow
{
    int number = 0;
    Vec2 x; ///< px
    Vec2 v; ///< px/frame
    Vec2 a; ///< px/frame^2
};

// Each rule with the numbers that it needs at hand. What it computes is the function that the code panel shows.

auto ready(rules::Falls rule)
{
    return [by = rule.by](PointNow &point) { point.a.y = point.a.y + by; };
}

auto ready(rules::FallsAtOnce rule)
{
    return [by = rule.by](PointNow &point) { point.v.y = point.v.y + by; };
}

auto ready(rules::Kicks rule)
{
    return [h = rule.h](PointNow &point) { point.v = kick(point.v, point.a, h); };
}

auto ready(rules::Damps rule)
{
    return [keep = rule.keep](PointNow &point) { point.v = damp(point.v, keep); };
}

auto ready(rules::Moves rule)
{
    return [h = rule.h](PointNow &point) { point.x = move(point.x, point.v, h); };
}

void put(PointNow &point, const Motion &after)
{
    point.x = after.x;
    point.v = after.v;
}

auto ready(rules::MeetsWalls rule)
{
    return [room = rule.walls->room(), half = rule.walls->half().data()](PointNow &point) {
        put(point, walls(point.x, point.v, half[point.number], room));
    };
}

auto ready(rules::MeetsGround rule)
{
    return [soil = rule.ground->soil()](PointNow &point) { put(point, ground(point.x, point.v, soil)); };
}

template <class Rule, class... All>
constexpr bool isAmong = (std::is_same_v<Rule, All> || ...);

/// Where a rule may stand in a row of rules that is computed in one go: after those of a lower place. These are the rows
/// that steps come to; each is compiled.
template <class Rule>
constexpr int placeOf = isAmong<Rule, rules::Falls, rules::FallsAtOnce>        ? 1
                        : isAmong<Rule, rules::Kicks>                          ? 2
                        : isAmong<Rule, rules::Damps>                          ? 3
                        : isAmong<Rule, rules::Moves>                          ? 4
                        : isAmong<Rule, rules::MeetsWalls, rules::MeetsGround> ? 5
                                                                               : 0;

template <class Before, class Rule>
constexpr bool mayFollow()
{
    if (std::is_same_v<Before, rules::Falls>)
        return std::is_same_v<Rule, rules::Kicks>;
    if (std::is_same_v<Before, rules::FallsAtOnce> && std::is_same_v<Rule, rules::Kicks>)
        return false;
    return placeOf<Rule> > placeOf<Before> && (placeOf<Rule> < 5 || placeOf<Before> == 4);
}

/// Takes each point of `points` that feels forces through `all`, in order. Accelerations are read or written only where
/// one of them does so.
template <class... All>
void runThrough(State &state, Points points, All... all)
{
    const Columns position(state.position), velocity(state.velocity), acceleration(state.acceleration);
    const auto steps = std::make_tuple(ready(all)...);
    forEachFree(state.inverseMass.data(), points,
                [steps, x = position, v = velocity, a = acceleration](int i, bool feels) {
                    PointNow now{i, x.at(i), v.at(i), {}};
                    if constexpr (isAmong<rules::Kicks, All...>)
                        now.a = a.at(i);
                    std::apply([&](const auto &...step) { (step(now), ...); }, steps);
                    x.x[i] = feels ? now.x.x : x.x[i];
                    x.y[i] = feels ? now.x.y : x.y[i];
                    v.x[i] = feels ? now.v.x : v.x[i];
                    v.y[i] = feels ? now.v.y : v.y[i];
                    if constexpr (isAmong<rules::Falls, All...>)
                        a.y[i] = feels ? now.a.y : a.y[i];
                });
}

/// What computes `taken` and then the rules of `left` in one go; null where that is not compiled.
template <class Last, class... Taken>
Work inOneGo(std::span<const Phase> left, Taken... taken)
{
    if (left.empty()) {
        if constexpr (isAmong<rules::Moves, Taken...>)
            return [taken...](State &state, Points points) { runThrough(state, points, taken...); };
        else
            return nullptr;
    }
    return std::visit(
        [&]<class Rule>(const Rule &rule) -> Work {
            if constexpr (mayFollow<Last, Rule>())
                return inOneGo<Rule>(left.subspan(1), taken..., rule);
            else
                return nullptr;
        },
        left.front().rule);
}

/// The first of `phases`, made what all of them are, where that can be.
std::optional<Phase> asOne(std::span<const Phase> phases)
{
    const Points points = phases.front().points;
    Phase one;
    one.id = "joined";
    for (const Phase &phase : phases) {
        if (phase.points.first != points.first || phase.points.count != points.count || !phase.runOn)
            return {};
        one.moves = one.moves || phase.moves;
        one.kicks += phase.kicks;
        if (phase.effect)
            one.within.push_back(phase.effect);
    }
    one.points = points;
    one.group = phases.front().group;
    const Work work = inOneGo<std::monostate>(phases);
    if (!work)
        return {};
    setWork(one, work);
    return one;
}

}

std::vector<Phase> joined(const std::vector<Phase> &phases)
{
    std::vector<Phase> fewer;
    for (std::size_t i = 0; i < phases.size();) {
        std::size_t end = i + 1;
        while (end < phases.size() && !std::holds_alternative<std::monostate>(phases[end].rule))
            ++end;
        std::optional<Phase> one;
        for (; end > i + 1 && !one; --end)
            one = asOne({phases.data() + i, end - i});
        if (one)
            ++end; // the loop has gone one too far
        fewer.push_back(one ? *std::move(one) : phases[i]);
        i = end;
    }
    return fewer;
}

}
