#include "sim/effects/springs.h"

#include "sim/effects/slope.h"
#include "sim/error.h"

#include <algorithm>

namespace sim {

Springs::Springs(std::vector<Spring> springs, int points) : m_springs(std::move(springs))
{
    for (std::size_t i = 0; i < m_springs.size(); ++i) {
        const Spring &one = m_springs[i];
        for (const int end : {one.a, one.b}) {
            if (end < 0 || end >= points)
                throw Error("spring-without-end", {{"spring", std::to_string(i)},
                                                   {"end", std::to_string(end)},
                                                   {"points", std::to_string(points)}});
        }
        m_ends.push_back({one.a, one.b, one.k, one.length});
        m_ends.push_back({one.b, one.a, one.k, one.length});
    }
    std::stable_sort(m_ends.begin(), m_ends.end(),
                     [](const End &a, const End &b) { return a.mover < b.mover; });
}

std::vector<Region> Springs::regions(Directions directions) const
{
    return RadialSpring({}, 0.0, 0.0).regions(directions);
}

/// Calls `visit(end)` for each end that is in `movers` and feels its spring.
template <class Visit>
void Springs::forEach(const State &state, Points movers, Visit &&visit) const
{
    const auto before = [](const End &end, int point) { return end.mover < point; };
    auto end = std::lower_bound(m_ends.begin(), m_ends.end(), movers.first, before);
    for (; end != m_ends.end() && end->mover < movers.end(); ++end) {
        if (state.feels(end->mover))
            visit(*end);
    }
}

int Springs::count(const State &state, Points points) const
{
    int total = 0;
    forEach(state, points, [&](const End &) { ++total; });
    return total;
}

void Springs::ties(std::vector<Tie> &into) const
{
    for (const Spring &one : m_springs)
        into.emplace_back(one.a, one.b);
}

bool Springs::idle() const
{
    return std::all_of(m_springs.begin(), m_springs.end(), [](const Spring &one) { return one.k == 0.0; });
}

void Springs::add(const State &state, Points movers, double scale, Directions directions,
                  Eigen::ArrayX2d &into) const
{
    forEach(state, movers, [&](const End &end) {
        const auto out = [&](Vec2 d) {
            return directions == Directions::published ? publishedDirection(d).out
                                                       : direction(d, end.anchor, end.mover).out;
        };
        const Vec2 pull =
            radialSpring(state.at(end.mover), state.at(end.anchor), end.k, end.length, out).end.pull;
        const Vec2 a = (scale * state.inverseMass[end.mover]) * pull;
        into(end.mover, 0) += a.x;
        into(end.mover, 1) += a.y;
    });
}

bool Springs::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    forEach(state, movers, [&](const End &end) {
        const Slope slope = slopeToDistance(state.at(end.mover) - state.at(end.anchor), end.k, end.length);
        addSlopeBetween(into, end.mover, end.anchor, (scale * state.inverseMass[end.mover]) * slope);
    });
    return true;
}

std::optional<double> Springs::energy(const State &state) const
{
    double sum = 0.0;
    for (const Spring &one : m_springs) {
        if (!state.feels(one.a) && !state.feels(one.b))
            continue;
        const double stretch = length(state.at(one.a) - state.at(one.b)) - one.length;
        sum += 0.5 * one.k * stretch * stretch;
    }
    return sum;
}

bool Springs::balances(const State &state) const
{
    return std::all_of(m_springs.begin(), m_springs.end(),
                       [&](const Spring &one) { return state.feels(one.a) == state.feels(one.b); });
}

std::vector<Live> Springs::explainEnd(const State &state, const End &end, Directions directions) const
{
    std::vector<Live> heading;
    const RadialPull s =
        radialSpring(state.at(end.mover), state.at(end.anchor), end.k, end.length, [&](Vec2 d) {
            if (directions == Directions::published) {
                const PublishedHeading found = publishedDirection(d);
                heading = {{"angle", found.angle}, {"out", found.out}};
                return found.out;
            }
            const Heading found = direction(d, end.anchor, end.mover);
            heading = {{"length", found.length}, {"out", found.out}};
            return found.out;
        });
    std::vector<Live> all = {{"from", s.from}};
    all.insert(all.end(), heading.begin(), heading.end());
    all.insert(all.end(), {{"target", s.target}, {"d", s.end.d}, {"pull", s.end.pull}});
    return all;
}

std::vector<Live> Springs::explain(const State &state, int mover, Directions directions) const
{
    std::vector<Live> last;
    Vec2 sum;
    int felt = 0;
    forEach(state, {mover, 1}, [&](const End &end) {
        last = explainEnd(state, end, directions);
        Vec2 &pull = std::get<Vec2>(last.back().value);
        pull = state.inverseMass[mover] * pull;
        sum = sum + pull;
        ++felt;
    });
    if (felt > 1)
        return {{"pull", sum}};
    return last;
}

void Springs::rests(const State &state, std::vector<RestEnd> &into) const
{
    for (const Spring &one : m_springs) {
        into.push_back(restAt(state, one.a, one.b, one.length));
        into.push_back(restAt(state, one.b, one.a, one.length));
    }
}

}
