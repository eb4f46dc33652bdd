#include "sim/effects/constraints/sticks.h"

#include "sim/base/error.h"
#include "sim/scene/blueprint_draft.h"

namespace sim {

namespace {

/// What `stick` does to a state's points.
StickEnds endsOf(const Stick &one, const State &state, Directions directions)
{
    const Vec2 a = state.at(one.a), b = state.at(one.b);
    const double share = !state.feels(one.a) ? 0.0 : !state.feels(one.b) ? 1.0 : one.share;
    if (directions == Directions::published)
        return publishedStick(a, b, one.length, share);
    return stick(a, b, direction(a - b, one.b, one.a), one.length, share);
}

/// A stick from a point to itself is moved twice, one end after the other, as printed.
void put(State &state, const Stick &one, const StickEnds &ends)
{
    const Vec2 way = ends.b - state.at(one.b);
    state.place(one.a, ends.a);
    state.place(one.b, one.a == one.b ? ends.a + way : ends.b);
}

bool acts(const Stick &one, const State &state)
{
    return state.feels(one.a) || state.feels(one.b);
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

std::vector<Region> Sticks::regions(Directions directions) const
{
    const Region loop = {"sim/effects/constraints/sticks.cpp", "sticks"};
    if (directions == Directions::published)
        return {loop, {"sim/effects/constraints/stick.h", "published_stick"}};
    return {loop, {"sim/effects/constraints/stick.h", "stick"}, {"sim/base/direction.h", "direction"}};
}

// Shown lines are short.
// clang-format off
//! [sticks]
template <class Visit>
void Sticks::forEach(
    Points points, Visit &&visit) const
{
    for (int i = 0; i < m_iterations; ++i)
        for (const Stick &one : m_sticks)
            if (points.contains(
                    std::max(one.a, one.b)))
                visit(one);
}
//! [sticks]
// clang-format on

int Sticks::count(const State &state, Points points) const
{
    int total = 0;
    for (const Stick &one : m_sticks)
        total += points.contains(std::max(one.a, one.b)) && acts(one, state) ? 1 : 0;
    return total;
}

void Sticks::ties(std::vector<Tie> &into) const
{
    for (const Stick &one : m_sticks)
        into.emplace_back(one.a, one.b);
}

void Sticks::enforce(State &state, Points points, Directions directions, double) const
{
    forEach(points, [&](const Stick &one) {
        if (acts(one, state))
            put(state, one, endsOf(one, state, directions));
    });
}

std::vector<Live> Sticks::explain(const State &before, const State &after, int point) const
{
    const Points all = {0, before.points()};
    for (const Directions directions : {Directions::apart, Directions::published}) {
        State state = before;
        std::vector<Live> live;
        forEach(all, [&](const Stick &one) {
            if (!acts(one, state))
                return;
            const StickEnds ends = endsOf(one, state, directions);
            const bool isA = one.a == point;
            if (isA || one.b == point)
                live = {{"distance", ends.distance},
                        {"error", ends.error},
                        {isA ? "a" : "b", isA ? ends.a : ends.b, state.at(point)}};
            put(state, one, ends);
        });
        if (state.at(point) == after.at(point))
            return live;
    }
    return {}; // it ran on a share of the points only
}

void Sticks::rests(const State &state, std::vector<RestEnd> &into) const
{
    for (const Stick &one : m_sticks) {
        into.push_back(restAt(state, one.a, one.b, one.length));
        into.push_back(restAt(state, one.b, one.a, one.length));
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

bool Sticks::takeInto(Taken &into) const
{
    for (const Stick &one : m_sticks)
        into.blueprint.sticks.push_back({one.a, one.b, one.length, one.share});
    into.numbers["iterations"] = m_iterations;
    return true;
}

namespace {

constexpr Setting sticksSettings[] = {{
    .id = "iterations",
    .name = SIM_TEXT("Iterations"),
    .unit = SIM_TEXT("passes"),
    .help = SIM_TEXT("How often each frame goes through the list of sticks."),
    .preset = 10.0,
    .min = 1.0,
    .max = 1000.0,
    .sliderMin = 1.0,
    .sliderMax = 50.0,
    .decimals = 0,
    .meaning = Meaning::passes,
    .whole = true,
}};

}

namespace described {
constinit const Description sticks = {
    .id = "sticks",
    .title = SIM_TEXT("sticks"),
    .kind = Kind::stick,
    .purpose =
        SIM_TEXT("Give each pair of points its length back, by moving them: a stick does not stretch."),
    .settings = sticksSettings};
}

}
