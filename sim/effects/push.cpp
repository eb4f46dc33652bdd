#include "sim/effects/push.h"

#include "sim/effects/slope.h"

#include <algorithm>

namespace sim {

Push::Push(std::vector<int> points, double k, double distance, Reaction reaction)
    : m_points(std::move(points)), m_k(k), m_distance(distance), m_reaction(reaction)
{
    std::sort(m_points.begin(), m_points.end());
}

std::vector<Region> Push::regions(Directions directions) const
{
    const std::string way = directions == Directions::published ? "published_direction" : "direction";
    std::vector<Region> all = {{"sim/effects/push.h", "push"}, {"sim/direction.h", way}};
    if (m_reaction == Reaction::equal)
        all.push_back(reactionShown());
    return all;
}

/// Calls `visit(one, other)` for each pair whose lower number is in `movers` and whose push something feels.
template <class Visit>
void Push::forEach(const State &state, Points movers, Visit &&visit) const
{
    for (auto one = m_points.begin(); one != m_points.end(); ++one) {
        if (!movers.contains(*one))
            continue;
        for (auto other = std::next(one); other != m_points.end(); ++other) {
            if (state.feels(*one) || (m_reaction == Reaction::equal && state.feels(*other)))
                visit(*one, *other);
        }
    }
}

int Push::count(const State &state, Points points) const
{
    int total = 0;
    forEach(state, points, [&](int, int) { ++total; });
    return total;
}

void Push::ties(std::vector<Tie> &into) const
{
    for (std::size_t i = 1; i < m_points.size(); ++i)
        into.emplace_back(m_points[i - 1], m_points[i]);
}

PushPull Push::pushOn(const State &state, int one, int other, Directions directions) const
{
    return push(state.at(one), state.at(other), m_k, m_distance, [&](Vec2 d) {
        return directions == Directions::published ? publishedDirection(d).out : direction(d, other, one).out;
    });
}

void Push::add(const State &state, Points movers, double scale, Directions directions,
               Eigen::ArrayX2d &into) const
{
    const auto addTo = [&](int point, Vec2 pull) {
        const Vec2 a = (scale * state.inverseMass[point]) * pull;
        into(point, 0) += a.x;
        into(point, 1) += a.y;
    };
    forEach(state, movers, [&](int one, int other) {
        const Vec2 pull = pushOn(state, one, other, directions).pull;
        addTo(one, pull);
        if (m_reaction == Reaction::equal)
            addTo(other, sim::reaction(pull));
    });
}

bool Push::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    forEach(state, movers, [&](int one, int other) {
        const Vec2 from = state.at(one) - state.at(other);
        if (length(from) >= m_distance)
            return;
        const Slope slope = scale * slopeToDistance(from, m_k, m_distance);
        if (state.feels(one))
            addSlopeBetween(into, one, other, state.inverseMass[one] * slope);
        if (m_reaction == Reaction::equal && state.feels(other))
            addSlopeBetween(into, other, one, state.inverseMass[other] * slope);
    });
    return true;
}

std::optional<double> Push::energy(const State &state) const
{
    double sum = 0.0;
    bool oneWay = false;
    forEach(state, {0, state.points()}, [&](int one, int other) {
        oneWay = oneWay || (m_reaction == Reaction::none && state.feels(other));
        const double missing = std::max(0.0, m_distance - length(state.at(one) - state.at(other)));
        sum += 0.5 * m_k * missing * missing;
    });
    return oneWay ? std::nullopt : std::optional(sum);
}

bool Push::balances(const State &state) const
{
    bool all = m_reaction == Reaction::equal;
    forEach(state, {0, state.points()},
            [&](int one, int other) { all = all && state.feels(one) && state.feels(other); });
    return all;
}

std::vector<Live> Push::explain(const State &state, int mover, Directions directions) const
{
    Vec2 sum;
    std::vector<Live> last;
    int felt = 0;
    forEach(state, {0, state.points()}, [&](int one, int other) {
        const bool back = other == mover && m_reaction == Reaction::equal;
        if ((one != mover && !back) || !state.feels(mover))
            return;
        const PushPull p = pushOn(state, one, other, directions);
        const Vec2 pull = state.inverseMass[mover] * (back ? sim::reaction(p.pull) : p.pull);
        last = {{"from", p.from}, {"missing", p.missing}, {"pull", pull}};
        sum = sum + pull;
        ++felt;
    });
    if (felt > 1)
        return {{"pull", sum}};
    return last;
}

}
