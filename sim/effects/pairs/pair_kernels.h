#pragma once

// The definitions of PairForce's members: for the source files of laws only.

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/reaction.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/simd/dispatch.h"

#include <algorithm>
#include <cstdint>

namespace sim {

/// The columns that a sum of pulls reads and writes, by point.
struct PullColumns
{
    const double *x, *y;       ///< px
    const double *inverseMass; ///< 0: feels nothing
    double *ax, *ay;           ///< px/frame^2

    PullColumns(const State &state, Eigen::ArrayX2d &into)
        : x(state.position.data()), y(x + state.position.rows()), inverseMass(state.inverseMass.data()),
          ax(into.data()), ay(ax + into.rows())
    {
    }
};

/// Adds the pulls of pairs, batch by batch: the one loop of every force between two points. `masses`: whether any point
/// has a mass other than 1. `pullOf(mover, anchor, place)` is the pull of the pair in that place of the list, from where
/// its two points are; `pullWhenCoincident(place)` that of two points in one place. Each pair is computed once for both of
/// its ends, and the pulls of one point come in the order of the list.
template <bool masses, class PullOf, class InOnePlace>
class PairSum
{
public:
    PairSum(const PairList &list, const PullColumns &sum, const PullOf &pullOf,
            const InOnePlace &pullWhenCoincident)
        : m_list(list), m_sum(sum), m_pullOf(pullOf), m_pullInOnePlace(pullWhenCoincident)
    {
    }

    void addAll()
    {
        for (const PairBatch &batch : m_list.batches) {
            if (batch.shape == PairBatch::Shape::row && batch.isDisjoint() && batch.isReciprocal) {
                addDisjointRow(batch);
                continue;
            }
            for (int from = 0; from < batch.count; from += most) {
                const int count = std::min(most, batch.count - from);
                if (batch.shape == PairBatch::Shape::row)
                    addRow(batch, from, count);
                else if (batch.shape == PairBatch::Shape::fan)
                    addFan(batch, from, count);
                else
                    addListed(batch.first + from, count);
            }
        }
    }

private:
    static constexpr int most = 256; ///< pulls that fit the nearest cache

    /// No two of its pairs have a point in common, so nothing need be kept in between.
    void addDisjointRow(const PairBatch &row)
    {
        const double *mx = m_sum.x + row.mover, *my = m_sum.y + row.mover;
        const double *nx = m_sum.x + row.anchor, *ny = m_sum.y + row.anchor;
        const double *mw = m_sum.inverseMass + row.mover, *nw = m_sum.inverseMass + row.anchor;
        double *px = m_sum.ax + row.mover, *py = m_sum.ay + row.mover;
        double *qx = m_sum.ax + row.anchor, *qy = m_sum.ay + row.anchor;
        const PullOf pullOf = m_pullOf; // numbers that no store can change
        const int count = row.count, first = row.first;
        std::int64_t close = 0;
        SIM_TURNS_ARE_APART
        for (int i = 0; i < count; ++i) {
            const PairPull one = pullOf(Vec2{mx[i], my[i]}, Vec2{nx[i], ny[i]}, first + i);
            const bool inOne = one.length < coincidenceDistance;
            close |= inOne ? std::int64_t{1} : std::int64_t{0};
            const double x = inOne ? 0.0 : one.pull.x, y = inOne ? 0.0 : one.pull.y;
            px[i] = sumOf(px[i], mw[i], x);
            py[i] = sumOf(py[i], mw[i], y);
            qx[i] = sumOf(qx[i], nw[i], -x);
            qy[i] = sumOf(qy[i], nw[i], -y);
        }
        for (int i = 0; close != 0 && i < count; ++i) {
            if (!(pullOf(Vec2{mx[i], my[i]}, Vec2{nx[i], ny[i]}, first + i).length < coincidenceDistance))
                continue;
            const Vec2 pull = m_pullInOnePlace(first + i);
            addTo(row.mover + i, pull.x, pull.y);
            addTo(row.anchor + i, -pull.x, -pull.y);
        }
    }

    void addRow(const PairBatch &row, int from, int count)
    {
        const int mover = row.mover + from, anchor = row.anchor + from;
        const double *mx = m_sum.x + mover, *my = m_sum.y + mover, *nx = m_sum.x + anchor,
                     *ny = m_sum.y + anchor;
        compute(
            row.first + from, count,
            [=](int i) {
                return Vec2{mx[i], my[i]};
            },
            [=](int i) {
                return Vec2{nx[i], ny[i]};
            });
        // A point that is the anchor of one pair and the mover of another gets first what comes first in the list.
        if (row.isReciprocal && row.anchor > row.mover)
            addToRow(anchor, count, -1.0);
        addToRow(mover, count, 1.0);
        if (row.isReciprocal && row.anchor < row.mover)
            addToRow(anchor, count, -1.0);
    }

    void addFan(const PairBatch &fan, int from, int count)
    {
        const int mover = fan.mover, anchor = fan.anchor + from;
        const Vec2 at = {m_sum.x[mover], m_sum.y[mover]};
        const double *nx = m_sum.x + anchor, *ny = m_sum.y + anchor;
        compute(
            fan.first + from, count, [=](int) { return at; },
            [=](int i) {
                return Vec2{nx[i], ny[i]};
            });
        if (fan.isReciprocal)
            addToRow(anchor, count, -1.0);
        const double share = m_sum.inverseMass[mover];
        double ax = m_sum.ax[mover], ay = m_sum.ay[mover];
        for (int i = 0; i < count; ++i) {
            ax = sumOf(ax, share, m_x[i]);
            ay = sumOf(ay, share, m_y[i]);
        }
        m_sum.ax[mover] = ax;
        m_sum.ay[mover] = ay;
    }

    void addListed(int first, int count)
    {
        const PointPair *pairs = m_list.pairs.data() + first;
        const double *x = m_sum.x, *y = m_sum.y;
        compute(
            first, count,
            [=](int i) {
                return Vec2{x[pairs[i].mover], y[pairs[i].mover]};
            },
            [=](int i) {
                return Vec2{x[pairs[i].anchor], y[pairs[i].anchor]};
            });
        for (int i = 0; i < count; ++i) {
            addTo(pairs[i].mover, m_x[i], m_y[i]);
            if (pairs[i].isReciprocal)
                addTo(pairs[i].anchor, -m_x[i], -m_y[i]);
        }
    }

    /// The pulls of `count` pairs, from place `first` of the list on.
    template <class MoverAt, class AnchorAt>
    void compute(int first, int count, const MoverAt &moverAt, const AnchorAt &anchorAt)
    {
        const PullOf pullOf = m_pullOf; // numbers that no store can change
        std::int64_t close = 0;
        SIM_TURNS_ARE_APART
        for (int i = 0; i < count; ++i) {
            const PairPull one = pullOf(moverAt(i), anchorAt(i), first + i);
            m_x[i] = one.pull.x;
            m_y[i] = one.pull.y;
            close |= one.length < coincidenceDistance ? std::int64_t{1} : std::int64_t{0};
        }
        for (int i = 0; close != 0 && i < count; ++i) {
            if (!(pullOf(moverAt(i), anchorAt(i), first + i).length < coincidenceDistance))
                continue;
            const Vec2 pull = m_pullInOnePlace(first + i);
            m_x[i] = pull.x;
            m_y[i] = pull.y;
        }
    }

    /// `sum` and what a point of that inverse mass gets from `pull`.
    static double sumOf(double sum, double inverseMass, double pull)
    {
        if constexpr (masses)
            return inverseMass != 0.0 ? sum + inverseMass * pull : sum;
        else
            return sum + pull;
    }

    void addTo(int point, double x, double y)
    {
        m_sum.ax[point] = sumOf(m_sum.ax[point], m_sum.inverseMass[point], x);
        m_sum.ay[point] = sumOf(m_sum.ay[point], m_sum.inverseMass[point], y);
    }

    void addToRow(int point, int count, double sign)
    {
        const double *share = m_sum.inverseMass + point, *x = m_x, *y = m_y;
        double *ax = m_sum.ax + point, *ay = m_sum.ay + point;
        SIM_TURNS_ARE_APART
        for (int i = 0; i < count; ++i) {
            ax[i] = sumOf(ax[i], share[i], sign * x[i]);
            ay[i] = sumOf(ay[i], share[i], sign * y[i]);
        }
    }

    const PairList &m_list;
    const PullColumns m_sum;
    const PullOf m_pullOf;
    const InOnePlace &m_pullInOnePlace;
    // These begin without values: what is read has been written before.
    double m_x[most];
    double m_y[most];
};

/// Whether no point that these pairs pull has a mass other than 1.
inline bool areOfMassOne(const double *inverseMass, const PairList &list)
{
    std::int64_t others = 0;
    for (const PointRange &range : list.ranges) {
        for (int i = range.first; i < range.end(); ++i)
            others |= inverseMass[i] != 1.0 ? std::int64_t{1} : std::int64_t{0};
    }
    return others == 0;
}

template <class Law>
PairForce<Law>::PairForce(Law law, std::vector<PointPair> links, std::vector<Numbers> numbers)
    : m_law(std::move(law)), m_numbers(std::move(numbers)),
      m_links(std::move(links), Law::isSymmetric, [this](int a, int b) { return of(a) == of(b); }),
      m_all(listOf({{0, m_links.points()}}))
{
}

template <class Law>
std::vector<Region> PairForce<Law>::regions(DirectionRule directionRule) const
{
    std::vector<Region> all = m_law.regions(directionRule);
    if (std::any_of(links().begin(), links().end(), [](const PointPair &link) { return link.isReciprocal; }))
        all.push_back(reactionRegion());
    return all;
}
template <class Law>
bool PairForce<Law>::isIdle() const
{
    return std::all_of(m_numbers.begin(), m_numbers.end(),
                       [this](const Numbers &one) { return m_law.isIdle(one); });
}
template <class Law>
int PairForce<Law>::count(const State &state, PointRange points) const
{
    int total = 0;
    forEach(state, points, [&](const PointPair &) { ++total; });
    return total;
}
template <class Law>
void PairForce<Law>::addCouplings(std::vector<Coupling> &into) const
{
    for (const PointPair &pair : m_links.pairs())
        into.emplace_back(pair.mover, pair.anchor);
}
template <class Law>
void PairForce<Law>::add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                         Eigen::ArrayX2d &into) const
{
    const auto addTo = [&](int point, Vec2 pull) {
        const double share = state.inverseMass[point];
        if (share == 0.0)
            return;
        into(point, 0) += scale * (share * pull.x);
        into(point, 1) += scale * (share * pull.y);
    };
    if (directionRule == DirectionRule::published) {
        forEach(state, movers, [&](const PointPair &link) {
            const Vec2 pull = m_law.published(state.positionOf(link.mover), state.positionOf(link.anchor),
                                              now(state, link.index));
            addTo(link.mover, pull);
            if (link.isReciprocal)
                addTo(link.anchor, -1.0 * pull);
        });
        return;
    }
    if (scale == 1.0 && movers.first == 0 && movers.count >= state.pointCount()) {
        addList(*m_all, state, into);
        return;
    }
    for (const PointPair &pair : m_all->pairs) {
        const bool moves = movers.contains(pair.mover),
                   answers = pair.isReciprocal && movers.contains(pair.anchor);
        if (!moves && !answers)
            continue;
        const Vec2 pull = pullOf(state, pair);
        if (moves)
            addTo(pair.mover, pull);
        if (answers)
            addTo(pair.anchor, -1.0 * pull);
    }
}
template <class Law>
AccelerationAdder PairForce<Law>::adderFor(const std::vector<PointRange> &ranges) const
{
    return [this, list = listOf(ranges)](const State &state, Eigen::ArrayX2d &into) {
        addList(*list, state, into);
    };
}
template <class Law>
bool PairForce<Law>::addJacobian(const State &state, PointRange movers, double scale,
                                 DirectionRule directionRule, Jacobian &jacobian) const
{
    const auto addEnd = [&](int end, int other, const PairJacobian &block) {
        if (state.isDynamic(end))
            addPairJacobian(jacobian, end, other, (scale * state.inverseMass[end]) * block);
    };
    const auto addPair = [&](const PointPair &pair, bool ofMover, bool ofAnchor) {
        if (!ofMover && !ofAnchor)
            return;
        const PairJacobian block = m_law.jacobian(state.positionOf(pair.mover), state.positionOf(pair.anchor),
                                                  now(state, pair.index));
        if (ofMover)
            addEnd(pair.mover, pair.anchor, block);
        if (ofAnchor)
            addEnd(pair.anchor, pair.mover, block);
    };
    if (directionRule == DirectionRule::published) {
        forEach(state, movers, [&](const PointPair &link) { addPair(link, true, link.isReciprocal); });
        return true;
    }
    for (const PointPair &pair : m_links.pairs())
        addPair(pair, movers.contains(pair.mover), pair.isReciprocal && movers.contains(pair.anchor));
    return true;
}

template <class Law>
std::optional<double> PairForce<Law>::potentialEnergy(const State &state) const
{
    double sum = 0.0;
    for (const PointPair &pair : m_links.pairs()) {
        const bool mover = state.isDynamic(pair.mover), anchor = state.isDynamic(pair.anchor);
        if (mover && anchor && !pair.isReciprocal)
            return {};
        if (mover || (anchor && pair.isReciprocal))
            sum += m_law.energy(state.positionOf(pair.mover), state.positionOf(pair.anchor),
                                now(state, pair.index));
    }
    return sum;
}
template <class Law>
bool PairForce<Law>::conservesMomentum(const State &state) const
{
    return std::all_of(m_links.pairs().begin(), m_links.pairs().end(), [&](const PointPair &pair) {
        return state.isDynamic(pair.mover) == (pair.isReciprocal && state.isDynamic(pair.anchor));
    });
}
template <class Law>
std::vector<LiveValue> PairForce<Law>::explain(const State &state, int mover,
                                               DirectionRule directionRule) const
{
    std::vector<LiveValue> last;
    Vec2 sum;
    int felt = 0;
    const auto take = [&](const PointPair &link, int end, double sign) {
        last = m_law.liveValues(state.positionOf(link.mover), state.positionOf(link.anchor),
                                fallbackDirection(link.anchor, link.mover), now(state, link.index),
                                directionRule);
        Vec2 &pull = std::get<Vec2>(last.back().value);
        pull = (sign * state.inverseMass[end]) * pull;
        sum = sum + pull;
        ++felt;
    };
    for (const PointPair &link : m_links.links()) {
        if (link.mover == mover && state.isDynamic(mover))
            take(link, mover, 1.0);
        else if (link.anchor == mover && link.isReciprocal && state.isDynamic(mover))
            take(link, mover, -1.0);
    }
    if (felt > 1)
        return {{"pull", sum}};
    return last;
}
template <class Law>
void PairForce<Law>::addRestTargets(const State &state, std::vector<RestTarget> &into) const
{
    if constexpr (requires(const PointPair &link) { m_law.rest(state, link, of(0)); }) {
        for (const PointPair &link : links())
            into.push_back(m_law.rest(state, link, now(state, link.index)));
    }
}
template <class Law>
bool PairForce<Law>::addToDraft(BlueprintDraft &draft) const
{
    if constexpr (requires { m_law.restLength(of(0)); }) {
        for (const PointPair &pair : m_links.pairs()) {
            const Numbers &own = of(pair.index);
            draft.addSpring({pair.mover, pair.anchor, own.k, m_law.restLength(own)}, pair.isReciprocal);
        }
        return true;
    }
    return false;
}
/// Calls `visit(link)` for each link whose mover is among `movers` and whose pull something feels.
template <class Law>
template <class Visit>
void PairForce<Law>::forEach(const State &state, PointRange movers, Visit &&visit) const
{
    for (auto link = m_links.firstOf(movers.first);
         link != m_links.links().end() && link->mover < movers.end(); ++link) {
        if (state.isDynamic(link->mover) || (link->isReciprocal && state.isDynamic(link->anchor)))
            visit(*link);
    }
}
template <class Law>
Vec2 PairForce<Law>::pullOf(const State &state, const PointPair &pair) const
{
    const Numbers numbers = now(state, pair.index);
    const PairPull one = m_law.pull(state.positionOf(pair.mover), state.positionOf(pair.anchor), numbers);
    return one.length < coincidenceDistance
               ? m_law.pullWhenCoincident(fallbackDirection(pair.anchor, pair.mover), numbers)
               : one.pull;
}
template <class Law>
auto PairForce<Law>::listOf(const std::vector<PointRange> &ranges) const
    -> std::shared_ptr<const NumberedList>
{
    NumberedList list{{m_links.batches(ranges, Law::isSymmetric)}, {}};
    const auto isFirst = [&](const PointPair &pair) {
        return of(pair.index) == of(list.pairs.front().index);
    };
    const bool areEqual = std::all_of(list.pairs.begin(), list.pairs.end(), isFirst);
    for (std::size_t i = 0; i < (areEqual ? std::min<std::size_t>(1, list.pairs.size()) : list.pairs.size());
         ++i)
        list.numbers.push_back(of(list.pairs[i].index));
    return std::make_shared<const NumberedList>(std::move(list));
}
template <class Law>
void PairForce<Law>::addList(const NumberedList &list, const State &state, Eigen::ArrayX2d &into) const
{
    if (list.pairs.empty())
        return;
    const PullColumns sum(state, into);
    const auto inOnePlaceOf = [&](int place) {
        const PointPair &pair = list.pairs[static_cast<std::size_t>(place)];
        return m_law.pullWhenCoincident(fallbackDirection(pair.anchor, pair.mover), now(state, pair.index));
    };
    const auto addAll = [&]<class PullOf>(const PullOf &pullOf) {
        using InOnePlace = decltype(inOnePlaceOf);
        dispatch([&] {
            if (areOfMassOne(state.inverseMass.data(), list))
                PairSum<false, PullOf, InOnePlace>(list, sum, pullOf, inOnePlaceOf).addAll();
            else
                PairSum<true, PullOf, InOnePlace>(list, sum, pullOf, inOnePlaceOf).addAll();
        });
    };
    if constexpr (requires { m_law.now(state, of(0)); }) {
        addAll([&](Vec2 mover, Vec2 anchor, int place) {
            return m_law.pull(mover, anchor, now(state, list.pairs[static_cast<std::size_t>(place)].index));
        });
    } else if (list.numbers.size() == 1) {
        addAll([law = m_law, same = list.numbers.front()](Vec2 mover, Vec2 anchor, int) {
            return law.pull(mover, anchor, same);
        });
    } else {
        addAll([law = m_law, numbers = list.numbers.data()](Vec2 mover, Vec2 anchor, int place) {
            return law.pull(mover, anchor, numbers[place]);
        });
    }
}
}
