#pragma once

// Defines the members of PairForce. Only the source files of laws include it.

#include "sim/effects/pairs/pair_force.h"
#include "sim/effects/pairs/reaction.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/simd/dispatch.h"

#include <algorithm>
#include <cstdint>

namespace sim {

/// The columns of the state that a sum of pulls reads, and the columns to which it adds. All are indexed by
/// point.
struct PullColumns
{
    const double *x, *y;       ///< px
    const double *inverseMass; ///< 0: not dynamic
    double *ax, *ay;           ///< px/frame^2

    PullColumns(const State &state, Eigen::ArrayX2d &into)
        : x(state.position.data()), y(x + state.position.rows()), inverseMass(state.inverseMass.data()),
          ax(into.data()), ay(ax + into.rows())
    {
    }
};

/// Adds the pulls of a PairList, batch by batch. All pair forces use this loop. It computes each pair once
/// for both ends and adds the pulls on a point in the order of the list. `masses`: whether any point has a
/// mass other than 1. `pullOf(mover, anchor, index)` returns the pull of the pair with that index in the
/// list, from the positions of its two points. `coincidentPullOf(index)` returns the pull if the two points
/// coincide.
template <bool masses, class PullOf, class CoincidentPullOf>
class PairSum
{
public:
    PairSum(const PairList &list, const PullColumns &columns, const PullOf &pullOf,
            const CoincidentPullOf &coincidentPullOf)
        : m_list(list), m_columns(columns), m_pullOf(pullOf), m_coincidentPullOf(coincidentPullOf)
    {
    }

    SIM_INLINED void addAll()
    {
        for (const PairBatch &batch : m_list.batches) {
            if (batch.shape == PairBatch::Shape::row && batch.isDisjoint() && batch.isReciprocal) {
                addDisjointRow(batch);
                continue;
            }
            for (int from = 0; from < batch.count; from += chunkSize) {
                const int count = std::min(chunkSize, batch.count - from);
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
    static constexpr int chunkSize = 256; ///< number of pulls that fit the L1 cache

    /// Adds the pulls of a row whose pairs have no point in common, without the buffers m_x and m_y.
    SIM_INLINED void addDisjointRow(const PairBatch &row)
    {
        const double *moverX = m_columns.x + row.mover, *moverY = m_columns.y + row.mover;
        const double *anchorX = m_columns.x + row.anchor, *anchorY = m_columns.y + row.anchor;
        const double *moverInverseMass = m_columns.inverseMass + row.mover,
                     *anchorInverseMass = m_columns.inverseMass + row.anchor;
        double *moverAx = m_columns.ax + row.mover, *moverAy = m_columns.ay + row.mover;
        double *anchorAx = m_columns.ax + row.anchor, *anchorAy = m_columns.ay + row.anchor;
        const PullOf pullOf = m_pullOf; // a copy, which stores to the columns cannot change
        const int count = row.count, first = row.first;
        std::int64_t anyCoincident = 0;
        SIM_INDEPENDENT_ITERATIONS
        for (int i = 0; i < count; ++i) {
            const PairPull found =
                pullOf(Vec2{moverX[i], moverY[i]}, Vec2{anchorX[i], anchorY[i]}, first + i);
            const bool isCoincident = found.length < coincidenceDistance;
            anyCoincident |= isCoincident ? std::int64_t{1} : std::int64_t{0};
            const double x = isCoincident ? 0.0 : found.pull.x, y = isCoincident ? 0.0 : found.pull.y;
            moverAx[i] = plusPull(moverAx[i], moverInverseMass[i], x);
            moverAy[i] = plusPull(moverAy[i], moverInverseMass[i], y);
            anchorAx[i] = plusPull(anchorAx[i], anchorInverseMass[i], -x);
            anchorAy[i] = plusPull(anchorAy[i], anchorInverseMass[i], -y);
        }
        for (int i = 0; anyCoincident != 0 && i < count; ++i) {
            if (!(pullOf(Vec2{moverX[i], moverY[i]}, Vec2{anchorX[i], anchorY[i]}, first + i).length <
                  coincidenceDistance))
                continue;
            const Vec2 pull = m_coincidentPullOf(first + i);
            addTo(row.mover + i, pull.x, pull.y);
            addTo(row.anchor + i, -pull.x, -pull.y);
        }
    }

    SIM_INLINED void addRow(const PairBatch &row, int from, int count)
    {
        const int mover = row.mover + from, anchor = row.anchor + from;
        const double *moverX = m_columns.x + mover, *moverY = m_columns.y + mover,
                     *anchorX = m_columns.x + anchor, *anchorY = m_columns.y + anchor;
        compute(
            row.first + from, count,
            [=](int i) {
                return Vec2{moverX[i], moverY[i]};
            },
            [=](int i) {
                return Vec2{anchorX[i], anchorY[i]};
            });
        // If a point is the anchor of one pair and the mover of another, the earlier pair in the list is
        // added first.
        if (row.isReciprocal && row.anchor > row.mover)
            addToRow(anchor, count, -1.0);
        addToRow(mover, count, 1.0);
        if (row.isReciprocal && row.anchor < row.mover)
            addToRow(anchor, count, -1.0);
    }

    SIM_INLINED void addFan(const PairBatch &fan, int from, int count)
    {
        const int mover = fan.mover, anchor = fan.anchor + from;
        const Vec2 at = {m_columns.x[mover], m_columns.y[mover]};
        const double *anchorX = m_columns.x + anchor, *anchorY = m_columns.y + anchor;
        compute(
            fan.first + from, count, [=](int) { return at; },
            [=](int i) {
                return Vec2{anchorX[i], anchorY[i]};
            });
        if (fan.isReciprocal)
            addToRow(anchor, count, -1.0);
        const double inverseMass = m_columns.inverseMass[mover];
        double ax = m_columns.ax[mover], ay = m_columns.ay[mover];
        for (int i = 0; i < count; ++i) {
            ax = plusPull(ax, inverseMass, m_x[i]);
            ay = plusPull(ay, inverseMass, m_y[i]);
        }
        m_columns.ax[mover] = ax;
        m_columns.ay[mover] = ay;
    }

    SIM_INLINED void addListed(int first, int count)
    {
        const PointPair *pairs = m_list.pairs.data() + first;
        const double *x = m_columns.x, *y = m_columns.y;
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

    /// Computes the pulls of `count` pairs, from index `first` of the list on, into m_x and m_y.
    template <class MoverAt, class AnchorAt>
    SIM_INLINED void compute(int first, int count, const MoverAt &moverAt, const AnchorAt &anchorAt)
    {
        const PullOf pullOf = m_pullOf; // a copy, which stores to the columns cannot change
        std::int64_t anyCoincident = 0;
        SIM_INDEPENDENT_ITERATIONS
        for (int i = 0; i < count; ++i) {
            const PairPull found = pullOf(moverAt(i), anchorAt(i), first + i);
            m_x[i] = found.pull.x;
            m_y[i] = found.pull.y;
            anyCoincident |= found.length < coincidenceDistance ? std::int64_t{1} : std::int64_t{0};
        }
        for (int i = 0; anyCoincident != 0 && i < count; ++i) {
            if (!(pullOf(moverAt(i), anchorAt(i), first + i).length < coincidenceDistance))
                continue;
            const Vec2 pull = m_coincidentPullOf(first + i);
            m_x[i] = pull.x;
            m_y[i] = pull.y;
        }
    }

    /// Returns `sum` plus the acceleration that `pull` gives a point with the inverse mass `inverseMass`.
    SIM_INLINED static double plusPull(double sum, double inverseMass, double pull)
    {
        if constexpr (masses)
            return inverseMass != 0.0 ? sum + inverseMass * pull : sum;
        else
            return sum + pull;
    }

    SIM_INLINED void addTo(int point, double x, double y)
    {
        m_columns.ax[point] = plusPull(m_columns.ax[point], m_columns.inverseMass[point], x);
        m_columns.ay[point] = plusPull(m_columns.ay[point], m_columns.inverseMass[point], y);
    }

    SIM_INLINED void addToRow(int point, int count, double sign)
    {
        const double *inverseMass = m_columns.inverseMass + point, *x = m_x, *y = m_y;
        double *ax = m_columns.ax + point, *ay = m_columns.ay + point;
        SIM_INDEPENDENT_ITERATIONS
        for (int i = 0; i < count; ++i) {
            ax[i] = plusPull(ax[i], inverseMass[i], sign * x[i]);
            ay[i] = plusPull(ay[i], inverseMass[i], sign * y[i]);
        }
    }

    const PairList &m_list;
    const PullColumns m_columns;
    const PullOf m_pullOf;
    const CoincidentPullOf &m_coincidentPullOf;
    // Not initialised, to save time: compute() writes every entry before it is read.
    double m_x[chunkSize];
    double m_y[chunkSize];
};

/// Returns whether all points in the ranges of `list` have mass 1.
SIM_INLINED inline bool areOfMassOne(const double *inverseMass, const PairList &list)
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
      m_links(std::move(links), Law::isSymmetric,
              [this](int a, int b) { return storedNumbers(a) == storedNumbers(b); }),
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
                       [this](const Numbers &numbers) { return m_law.isIdle(numbers); });
}
template <class Law>
int PairForce<Law>::count(const State &state, PointRange points) const
{
    int total = 0;
    forEachLink(state, points, [&](const PointPair &) { ++total; });
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
        const double inverseMass = state.inverseMass[point];
        if (inverseMass == 0.0)
            return;
        into(point, 0) += scale * (inverseMass * pull.x);
        into(point, 1) += scale * (inverseMass * pull.y);
    };
    if (directionRule == DirectionRule::published) {
        forEachLink(state, movers, [&](const PointPair &link) {
            const Vec2 pull = m_law.published(state.positionOf(link.mover), state.positionOf(link.anchor),
                                              currentNumbers(state, link.index));
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
        const bool isMoverInside = movers.contains(pair.mover),
                   isAnchorInside = pair.isReciprocal && movers.contains(pair.anchor);
        if (!isMoverInside && !isAnchorInside)
            continue;
        const Vec2 pull = pullOf(state, pair);
        if (isMoverInside)
            addTo(pair.mover, pull);
        if (isAnchorInside)
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
                                                  currentNumbers(state, pair.index));
        if (ofMover)
            addEnd(pair.mover, pair.anchor, block);
        if (ofAnchor)
            addEnd(pair.anchor, pair.mover, block);
    };
    if (directionRule == DirectionRule::published) {
        forEachLink(state, movers, [&](const PointPair &link) { addPair(link, true, link.isReciprocal); });
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
                                currentNumbers(state, pair.index));
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
    std::vector<LiveValue> liveValues;
    Vec2 sum;
    int count = 0;
    const auto addLink = [&](const PointPair &link, int end, double sign) {
        liveValues = m_law.liveValues(state.positionOf(link.mover), state.positionOf(link.anchor),
                                      fallbackDirection(link.anchor, link.mover),
                                      currentNumbers(state, link.index), directionRule);
        Vec2 &pull = std::get<Vec2>(liveValues.back().value);
        pull = (sign * state.inverseMass[end]) * pull;
        sum = sum + pull;
        ++count;
    };
    for (const PointPair &link : m_links.links()) {
        if (link.mover == mover && state.isDynamic(mover))
            addLink(link, mover, 1.0);
        else if (link.anchor == mover && link.isReciprocal && state.isDynamic(mover))
            addLink(link, mover, -1.0);
    }
    if (count > 1)
        return {{"pull", sum}};
    return liveValues;
}
template <class Law>
void PairForce<Law>::addRestTargets(const State &state, std::vector<RestTarget> &into) const
{
    if constexpr (requires(const PointPair &link) { m_law.restTarget(state, link, storedNumbers(0)); }) {
        for (const PointPair &link : links())
            into.push_back(m_law.restTarget(state, link, currentNumbers(state, link.index)));
    }
}
template <class Law>
bool PairForce<Law>::addToDraft(BlueprintDraft &draft) const
{
    if constexpr (requires { m_law.restLength(storedNumbers(0)); }) {
        for (const PointPair &pair : m_links.pairs()) {
            const Numbers &numbers = storedNumbers(pair.index);
            draft.addSpring({pair.mover, pair.anchor, numbers.k, m_law.restLength(numbers)},
                            pair.isReciprocal);
        }
        return true;
    }
    return false;
}
/// Calls `visit(link)` for each link whose mover is in `movers` and whose pull acts on a dynamic point.
template <class Law>
template <class Visit>
void PairForce<Law>::forEachLink(const State &state, PointRange movers, Visit &&visit) const
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
    const Numbers numbers = currentNumbers(state, pair.index);
    const PairPull found = m_law.pull(state.positionOf(pair.mover), state.positionOf(pair.anchor), numbers);
    return found.length < coincidenceDistance
               ? m_law.pullWhenCoincident(fallbackDirection(pair.anchor, pair.mover), numbers)
               : found.pull;
}
template <class Law>
auto PairForce<Law>::listOf(const std::vector<PointRange> &ranges) const
    -> std::shared_ptr<const NumberedList>
{
    NumberedList list{{m_links.batches(ranges, Law::isSymmetric)}, {}};
    const auto isFirst = [&](const PointPair &pair) {
        return storedNumbers(pair.index) == storedNumbers(list.pairs.front().index);
    };
    const bool areEqual = std::all_of(list.pairs.begin(), list.pairs.end(), isFirst);
    for (std::size_t i = 0; i < (areEqual ? std::min<std::size_t>(1, list.pairs.size()) : list.pairs.size());
         ++i)
        list.numbers.push_back(storedNumbers(list.pairs[i].index));
    return std::make_shared<const NumberedList>(std::move(list));
}
template <class Law>
void PairForce<Law>::addList(const NumberedList &list, const State &state, Eigen::ArrayX2d &into) const
{
    if (list.pairs.empty())
        return;
    const PullColumns columns(state, into);
    const auto coincidentPullOf = [&](int index) {
        const PointPair &pair = list.pairs[static_cast<std::size_t>(index)];
        return m_law.pullWhenCoincident(fallbackDirection(pair.anchor, pair.mover),
                                        currentNumbers(state, pair.index));
    };
    const auto addAll = [&]<class PullOf>(const PullOf &pullOf) {
        using CoincidentPullOf = decltype(coincidentPullOf);
        dispatch([&] {
            if (areOfMassOne(state.inverseMass.data(), list))
                PairSum<false, PullOf, CoincidentPullOf>(list, columns, pullOf, coincidentPullOf).addAll();
            else
                PairSum<true, PullOf, CoincidentPullOf>(list, columns, pullOf, coincidentPullOf).addAll();
        });
    };
    if constexpr (requires { m_law.currentNumbers(state, storedNumbers(0)); }) {
        addAll([&](Vec2 mover, Vec2 anchor, int index) {
            return m_law.pull(mover, anchor,
                              currentNumbers(state, list.pairs[static_cast<std::size_t>(index)].index));
        });
    } else if (list.numbers.size() == 1) {
        addAll([law = m_law, shared = list.numbers.front()](Vec2 mover, Vec2 anchor, int) {
            return law.pull(mover, anchor, shared);
        });
    } else {
        addAll([law = m_law, numbers = list.numbers.data()](Vec2 mover, Vec2 anchor, int index) {
            return law.pull(mover, anchor, numbers[index]);
        });
    }
}
}
