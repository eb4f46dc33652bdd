#include "sim/effects/pairs/links.h"

#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace sim {

namespace {

/// Pairs in shorter rows become listed pairs or fans, because such a short row does not run faster.
constexpr int minRowLength = 4;

/// Numbers the points of some ranges consecutively from 0 on.
class PointNumbering
{
public:
    explicit PointNumbering(const std::vector<PointRange> &ranges) : m_ranges(ranges)
    {
        int count = 0;
        for (const PointRange &range : ranges) {
            m_offsets.push_back(count);
            count += range.count;
        }
        m_count = count;
    }
    int count() const { return m_count; }
    /// Returns the number of `point`, which has to be in one of the ranges.
    std::size_t indexOf(int point) const
    {
        const auto range = std::upper_bound(m_ranges.begin(), m_ranges.end(), point,
                                            [](int at, const PointRange &one) { return at < one.end(); });
        return static_cast<std::size_t>(m_offsets[static_cast<std::size_t>(range - m_ranges.begin())] +
                                        point - range->first);
    }

private:
    const std::vector<PointRange> &m_ranges;
    std::vector<int> m_offsets;
    int m_count = 0;
};

/// Sorts pairs into rows. A pair joins the row that it continues, unless an earlier pair of one of its points
/// is in a later row. That would change the order of the pulls on the point.
class RowBuilder
{
public:
    explicit RowBuilder(const std::vector<PointRange> &ranges)
        : m_numbering(ranges), m_lastRow(static_cast<std::size_t>(m_numbering.count()), -1)
    {
    }

    void add(const PointPair &pair)
    {
        const auto open = m_open.find(key(pair.mover, pair.anchor, pair.isReciprocal));
        int row = open == m_open.end() ? -1 : open->second;
        if (row < lastRowOf(pair)) {
            row = static_cast<int>(m_rows.size());
            m_rows.emplace_back();
        }
        if (open != m_open.end() && open->second == row)
            m_open.erase(open);
        m_rows[static_cast<std::size_t>(row)].push_back(pair);
        m_open.insert_or_assign(key(pair.mover + 1, pair.anchor + 1, pair.isReciprocal), row);
        m_lastRow[m_numbering.indexOf(pair.mover)] = row;
        if (pair.isReciprocal)
            m_lastRow[m_numbering.indexOf(pair.anchor)] = row;
    }

    const std::vector<std::vector<PointPair>> &rows() const { return m_rows; }

private:
    /// Identifies a pair by its points and by whether it is reciprocal.
    static std::uint64_t key(int mover, int anchor, bool isReciprocal)
    {
        return static_cast<std::uint64_t>(mover) << 32 | static_cast<std::uint64_t>(anchor) << 1 |
               (isReciprocal ? 1U : 0U);
    }

    /// Returns the last row with a pull on a point that `pair` pulls too. Returns 0 if there is none, which
    /// is more than the -1 of a pair that continues no row.
    int lastRowOf(const PointPair &pair) const
    {
        const int lastOfMover = m_lastRow[m_numbering.indexOf(pair.mover)];
        const int last = pair.isReciprocal
                             ? std::max(lastOfMover, m_lastRow[m_numbering.indexOf(pair.anchor)])
                             : lastOfMover;
        return std::max(0, last);
    }

    PointNumbering m_numbering;
    std::vector<int> m_lastRow; ///< for each point, the last row with a pull on it; -1: none
    /// For the key() of a pair, the row that the pair would continue.
    std::unordered_map<std::uint64_t, int> m_open;
    std::vector<std::vector<PointPair>> m_rows;
};

/// Appends `pair` to the last batch of `list` if the two form a fan, otherwise as a new batch. If
/// `mayReverse`, swaps mover and anchor of reciprocal pairs where that makes a fan.
void append(PairList &list, PointPair pair, bool mayReverse)
{
    const auto reversed = [](const PointPair &one) {
        return PointPair{one.anchor, one.mover, one.index, one.isReciprocal};
    };
    const bool isReversible = mayReverse && pair.isReciprocal;
    PairBatch *last = list.batches.empty() ? nullptr : &list.batches.back();
    const auto continues = [&](const PointPair &one) {
        return last && last->shape != PairBatch::Shape::row && last->isReciprocal == one.isReciprocal &&
               one.mover == last->mover && one.anchor == last->anchor + last->count &&
               (last->count == 1 || last->shape == PairBatch::Shape::fan);
    };
    if (last && last->count == 1 && last->shape == PairBatch::Shape::listed && isReversible &&
        last->isReciprocal && !continues(pair) && pair.anchor == last->anchor &&
        pair.mover == last->mover + 1) {
        // Two pairs with the same anchor and consecutive movers are a fan after a swap.
        list.pairs.back() = reversed(list.pairs.back());
        std::swap(last->mover, last->anchor);
    }
    if (isReversible && !continues(pair) && continues(reversed(pair)))
        pair = reversed(pair);
    list.pairs.push_back(pair);
    const int index = static_cast<int>(list.pairs.size()) - 1;
    if (continues(pair)) {
        last->shape = PairBatch::Shape::fan;
        ++last->count;
    } else {
        list.batches.push_back(
            {PairBatch::Shape::listed, pair.mover, pair.anchor, index, 1, pair.isReciprocal});
    }
}

/// Joins neighbouring batches of listed pairs.
void joinListed(std::vector<PairBatch> &batches)
{
    std::vector<PairBatch> joined;
    for (const PairBatch &one : batches) {
        if (!joined.empty() && one.shape == PairBatch::Shape::listed &&
            joined.back().shape == PairBatch::Shape::listed)
            joined.back().count += one.count;
        else
            joined.push_back(one);
    }
    batches = std::move(joined);
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

void Links::buildIndex()
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

PairList Links::batches(const std::vector<PointRange> &ranges, bool isSymmetric) const
{
    const auto before = [&](int index, int mover) {
        return m_pairs[static_cast<std::size_t>(index)].mover < mover;
    };
    std::vector<int> selected; // indices in m_pairs, ascending: the order in which the pulls are computed
    for (const PointRange &range : ranges) {
        const auto first = std::lower_bound(m_byMover.begin(), m_byMover.end(), range.first, before);
        const auto last = std::lower_bound(first, m_byMover.end(), range.end(), before);
        selected.insert(selected.end(), first, last);
    }
    std::sort(selected.begin(), selected.end());
    RowBuilder rows(ranges);
    for (const int index : selected)
        rows.add(m_pairs[static_cast<std::size_t>(index)]);
    PairList list{{}, {}, ranges};
    list.pairs.reserve(selected.size());
    for (const std::vector<PointPair> &row : rows.rows()) {
        if (static_cast<int>(row.size()) < minRowLength) {
            for (const PointPair &pair : row)
                append(list, pair, isSymmetric);
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
