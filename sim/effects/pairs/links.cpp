#include "sim/effects/pairs/links.h"

#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace sim {

namespace {

/// A row shorter than this gains nothing: its pairs are listed.
constexpr int shortestRow = 4;

/// Numbers the points of some runs from 0 on.
class Places
{
public:
    explicit Places(const std::vector<PointRange> &ranges) : m_ranges(ranges)
    {
        int count = 0;
        for (const PointRange &range : ranges) {
            m_firsts.push_back(count);
            count += range.count;
        }
        m_count = count;
    }
    int count() const { return m_count; }
    std::size_t of(int point) const
    {
        const auto range = std::upper_bound(m_ranges.begin(), m_ranges.end(), point,
                                            [](int at, const PointRange &one) { return at < one.end(); });
        return static_cast<std::size_t>(m_firsts[static_cast<std::size_t>(range - m_ranges.begin())] + point -
                                        range->first);
    }

private:
    const std::vector<PointRange> &m_ranges;
    std::vector<int> m_firsts;
    int m_count = 0;
};

/// Puts pairs into rows, each into the first one that it continues without overtaking another pair of its points.
class Rows
{
public:
    explicit Rows(const std::vector<PointRange> &ranges)
        : m_places(ranges), m_last(static_cast<std::size_t>(m_places.count()), -1)
    {
    }

    void add(const PointPair &pair)
    {
        const auto open = m_open.find(key(pair.mover, pair.anchor, pair.isReciprocal));
        int row = open == m_open.end() ? -1 : open->second;
        if (row < lastOf(pair)) {
            row = static_cast<int>(m_rows.size());
            m_rows.emplace_back();
        }
        if (open != m_open.end() && open->second == row)
            m_open.erase(open);
        m_rows[static_cast<std::size_t>(row)].push_back(pair);
        m_open.insert_or_assign(key(pair.mover + 1, pair.anchor + 1, pair.isReciprocal), row);
        m_last[m_places.of(pair.mover)] = row;
        if (pair.isReciprocal)
            m_last[m_places.of(pair.anchor)] = row;
    }

    const std::vector<std::vector<PointPair>> &rows() const { return m_rows; }

private:
    static std::uint64_t key(int mover, int anchor, bool bothWays)
    {
        return static_cast<std::uint64_t>(mover) << 32 | static_cast<std::uint64_t>(anchor) << 1 |
               (bothWays ? 1U : 0U);
    }

    /// The last row that adds to a sum to which `pair` adds, or, for a pair that is the first, a row that is not there.
    int lastOf(const PointPair &pair) const
    {
        const int ofMover = m_last[m_places.of(pair.mover)];
        const int last = pair.isReciprocal ? std::max(ofMover, m_last[m_places.of(pair.anchor)]) : ofMover;
        return std::max(0, last);
    }

    Places m_places;
    std::vector<int> m_last;                       ///< of each point, the last row that adds to its sum
    std::unordered_map<std::uint64_t, int> m_open; ///< the row that a pair would continue
    std::vector<std::vector<PointPair>> m_rows;
};

/// Appends `pair` to the listed pairs, or to the fan, at the end of `list`.
void append(PairList &list, PointPair pair, bool mayTurn)
{
    const auto turned = [](const PointPair &one) {
        return PointPair{one.anchor, one.mover, one.index, one.isReciprocal};
    };
    const bool turns = mayTurn && pair.isReciprocal;
    PairBatch *last = list.batches.empty() ? nullptr : &list.batches.back();
    const auto continues = [&](const PointPair &one) {
        return last && last->shape != PairBatch::Shape::row && last->isReciprocal == one.isReciprocal &&
               one.mover == last->mover && one.anchor == last->anchor + last->count &&
               (last->count == 1 || last->shape == PairBatch::Shape::fan);
    };
    if (last && last->count == 1 && last->shape == PairBatch::Shape::listed && turns && last->isReciprocal &&
        !continues(pair) && pair.anchor == last->anchor && pair.mover == last->mover + 1) {
        list.pairs.back() =
            turned(list.pairs.back()); // movers one after the other: the same fan from its other side
        std::swap(last->mover, last->anchor);
    }
    if (turns && !continues(pair) && continues(turned(pair)))
        pair = turned(pair);
    list.pairs.push_back(pair);
    const int place = static_cast<int>(list.pairs.size()) - 1;
    if (continues(pair)) {
        last->shape = PairBatch::Shape::fan;
        ++last->count;
    } else {
        list.batches.push_back(
            {PairBatch::Shape::listed, pair.mover, pair.anchor, place, 1, pair.isReciprocal});
    }
}

/// Makes single pairs that follow each other one batch.
void joinListed(std::vector<PairBatch> &batches)
{
    std::vector<PairBatch> fewer;
    for (const PairBatch &one : batches) {
        if (!fewer.empty() && one.shape == PairBatch::Shape::listed &&
            fewer.back().shape == PairBatch::Shape::listed)
            fewer.back().count += one.count;
        else
            fewer.push_back(one);
    }
    batches = std::move(fewer);
}

}

std::vector<PointPair> pairsOf(const std::vector<Link> &links)
{
    std::vector<PointPair> pairs;
    pairs.reserve(links.size());
    for (const Link &link : links)
        pairs.push_back({link.mover, link.anchor});
    return pairs;
}

void Links::index()
{
    for (const PointPair &link : m_links)
        m_points = std::max({m_points, link.mover + 1, link.anchor + 1});
    const auto byMover = [](const PointPair &a, const PointPair &b) { return a.mover < b.mover; };
    std::stable_sort(m_links.begin(), m_links.end(), byMover);
    m_byMover.resize(m_pairs.size());
    std::iota(m_byMover.begin(), m_byMover.end(), 0);
    std::stable_sort(m_byMover.begin(), m_byMover.end(), [&](int a, int b) {
        return byMover(m_pairs[static_cast<std::size_t>(a)], m_pairs[static_cast<std::size_t>(b)]);
    });
}

std::vector<PointPair>::const_iterator Links::firstOf(int mover) const
{
    return std::partition_point(m_links.begin(), m_links.end(),
                                [mover](const PointPair &link) { return link.mover < mover; });
}

PairList Links::batches(const std::vector<PointRange> &ranges, bool areMutual) const
{
    const auto before = [&](int place, int mover) {
        return m_pairs[static_cast<std::size_t>(place)].mover < mover;
    };
    std::vector<int> inside; // places in the order in which pulls are computed
    for (const PointRange &range : ranges) {
        const auto first = std::lower_bound(m_byMover.begin(), m_byMover.end(), range.first, before);
        const auto last = std::lower_bound(first, m_byMover.end(), range.end(), before);
        inside.insert(inside.end(), first, last);
    }
    std::sort(inside.begin(), inside.end());
    Rows rows(ranges);
    for (const int place : inside)
        rows.add(m_pairs[static_cast<std::size_t>(place)]);
    PairList list{{}, {}, ranges};
    list.pairs.reserve(inside.size());
    for (const std::vector<PointPair> &row : rows.rows()) {
        if (static_cast<int>(row.size()) < shortestRow) {
            for (const PointPair &pair : row)
                append(list, pair, areMutual);
            continue;
        }
        list.batches.push_back({PairBatch::Shape::row, row.front().mover, row.front().anchor,
                                static_cast<int>(list.pairs.size()), static_cast<int>(row.size()),
                                row.front().isReciprocal});
        list.pairs.insert(list.pairs.end(), row.begin(), row.end());
    }
    joinListed(list.batches);
    return list;
}

}
