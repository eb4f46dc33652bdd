#include "app/model/learning/layered_layout.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace app {

namespace {

constexpr int sweeps = 24;
constexpr int starts = 100; ///< orders to begin with; takes some ms

/// Something in a row: a node, or the place where edges from one node pass.
struct RowItem
{
    bool isNode = true;
    int row = 0;
    std::vector<std::size_t> above = {}; ///< the items in the row above that it is joined with
    std::vector<std::size_t> below = {};
    double x = 0.0;
};

using Rows = std::vector<std::vector<std::size_t>>; ///< items, from left to right

/// Lays a graph out in the usual steps (Sugiyama, Tagawa and Toda 1981): rows, order within rows, places.
class Layering
{
public:
    Layering(const std::vector<std::vector<std::size_t>> &restsOn, int mostInRow)
        : m_restsOn(restsOn), m_most(mostInRow), m_bases(restsOn.size()), m_followers(restsOn.size())
    {
        chooseEdges();
        chooseRows();
        shortenEdges();
        closeGaps();
        addItems();
        chooseOrder();
        choosePlaces();
    }

    LayeredLayout result() const
    {
        LayeredLayout layout;
        layout.rows = static_cast<int>(m_rows.size());
        layout.width = m_width;
        for (std::size_t i = 0; i < m_restsOn.size(); ++i)
            layout.nodes.push_back(placeOf(i));
        for (const auto &[edge, items] : m_edges) {
            layout.edges.push_back(edge);
            for (const std::size_t item : items)
                layout.edges.back().between.push_back(placeOf(item));
        }
        return layout;
    }

private:
    LayeredLayout::Place placeOf(std::size_t item) const { return {m_items[item].row, m_items[item].x}; }

    // The edges

    void chooseEdges()
    {
        for (std::size_t i = 0; i < m_restsOn.size(); ++i) {
            for (const std::size_t base : m_restsOn[i]) {
                if (follows(i, base))
                    continue;
                m_bases[i].push_back(base);
                m_followers[base].push_back(i);
            }
        }
    }

    /// Returns whether `i` rests on `base` also by way of another node.
    bool follows(std::size_t i, std::size_t base) const
    {
        return std::any_of(m_restsOn[i].begin(), m_restsOn[i].end(),
                           [&](std::size_t other) { return other > base && leadsTo(other, base); });
    }

    /// Returns whether `i` rests on `base`, on something that does, and so on.
    bool leadsTo(std::size_t i, std::size_t base) const
    {
        std::vector<bool> isReached(i + 1, false);
        isReached[i] = true;
        for (std::size_t one = i; one > base; --one) {
            if (!isReached[one])
                continue;
            for (const std::size_t next : m_restsOn[one])
                isReached[next] = true;
        }
        return isReached[base];
    }

    // The rows

    /// Gives each node the highest row that has room below all that it rests on.
    void chooseRows()
    {
        for (const std::vector<std::size_t> &bases : m_bases) {
            int row = 0;
            for (const std::size_t one : bases)
                row = std::max(row, m_items[one].row + 1);
            while (countIn(row) >= m_most)
                ++row;
            m_items.push_back({.row = row});
        }
    }

    int countIn(int row) const
    {
        return static_cast<int>(std::count_if(m_items.begin(), m_items.end(),
                                              [row](const RowItem &one) { return one.row == row; }));
    }

    /// Moves nodes to other rows as long as that makes edges shorter.
    void shortenEdges()
    {
        for (int round = 0; round < sweeps; ++round) {
            bool isBetter = false;
            for (std::size_t i = 0; i < m_items.size(); ++i)
                isBetter = shortenEdgesOf(i) || isBetter;
            if (!isBetter)
                return;
        }
    }

    bool shortenEdgesOf(std::size_t node)
    {
        int first = 0, last = m_items[node].row;
        for (const std::size_t base : m_bases[node])
            first = std::max(first, m_items[base].row + 1);
        if (!m_followers[node].empty())
            last = std::numeric_limits<int>::max();
        for (const std::size_t follower : m_followers[node])
            last = std::min(last, m_items[follower].row - 1);
        // Each row farther down makes the edges from above longer by one, and those to below shorter.
        const auto up = m_bases[node].size(), down = m_followers[node].size();
        if (up == down)
            return false;
        const int was = m_items[node].row, step = up < down ? -1 : 1;
        int row = up < down ? last : first;
        while (row != was && countIn(row) >= m_most)
            row += step;
        m_items[node].row = row;
        return row != was;
    }

    /// Removes rows that are empty now.
    void closeGaps()
    {
        int count = 0;
        for (int row = 0; row <= static_cast<int>(m_items.size()); ++row) {
            if (countIn(row) == 0)
                continue;
            for (RowItem &one : m_items)
                one.row = one.row == row ? count : one.row;
            ++count;
        }
        m_rows.resize(static_cast<std::size_t>(count));
    }

    /// Joins the nodes. Long edges pass the rows between; those from the same node share their way as far as they can.
    void addItems()
    {
        for (std::size_t from = 0; from < m_restsOn.size(); ++from) {
            std::vector<std::size_t> way = {from};
            const int below = m_items[from].row + 1;
            for (const std::size_t to : m_followers[from]) {
                const auto length = static_cast<std::size_t>(m_items[to].row - below) + 1;
                while (way.size() < length) {
                    const int row = below - 1 + static_cast<int>(way.size());
                    m_items.push_back({.isNode = false, .row = row});
                    join(way.back(), m_items.size() - 1);
                    way.push_back(m_items.size() - 1);
                }
                join(way[length - 1], to);
                const auto end = way.begin() + static_cast<std::ptrdiff_t>(length);
                m_edges.emplace_back(LayeredLayout::Edge{from, to},
                                     std::vector<std::size_t>(way.begin() + 1, end));
            }
        }
        for (std::size_t i = 0; i < m_items.size(); ++i)
            m_rows[static_cast<std::size_t>(m_items[i].row)].push_back(i);
    }

    void join(std::size_t above, std::size_t below)
    {
        m_items[above].below.push_back(below);
        m_items[below].above.push_back(above);
    }

    // The order within rows

    /// Returns the position of each item in its row, from the middle.
    std::vector<double> positions(const Rows &rows) const
    {
        std::vector<double> all(m_items.size(), 0.0);
        for (const std::vector<std::size_t> &row : rows)
            notePositions(row, all);
        return all;
    }

    static void notePositions(const std::vector<std::size_t> &row, std::vector<double> &all)
    {
        for (std::size_t i = 0; i < row.size(); ++i)
            all[row[i]] = static_cast<double>(i) - static_cast<double>(row.size() - 1) / 2.0;
    }

    int crossings(const Rows &rows) const
    {
        const std::vector<double> at = positions(rows);
        int count = 0;
        std::vector<std::pair<double, double>> lines;
        for (const std::vector<std::size_t> &row : rows) {
            lines.clear();
            for (const std::size_t item : row) {
                for (const std::size_t below : m_items[item].below)
                    lines.emplace_back(at[item], at[below]);
            }
            for (std::size_t i = 0; i < lines.size(); ++i) {
                for (std::size_t j = i + 1; j < lines.size(); ++j) {
                    if ((lines[i].first - lines[j].first) * (lines[i].second - lines[j].second) < 0.0)
                        ++count;
                }
            }
        }
        return count;
    }

    /// Looks for an order with few crossings, from several orders to begin with.
    void chooseOrder()
    {
        const Rows first = m_rows;
        int fewest = crossings(m_rows);
        std::uint32_t number = 1;
        for (int start = 0; start < starts && fewest > 0; ++start) {
            Rows rows = first;
            if (start > 0) {
                for (std::vector<std::size_t> &row : rows)
                    shuffle(row, number);
            }
            Rows before; // what the sweep down began with
            for (int i = 0; i < sweeps && fewest > 0; ++i) {
                if (i % 2 == 0) {
                    if (rows == before)
                        break; // all later sweeps would do the same again
                    before = rows;
                }
                sortRows(rows, i % 2 == 0);
                swapNeighbours(rows);
                const int count = crossings(rows);
                if (count < fewest) {
                    fewest = count;
                    m_rows = rows;
                }
            }
        }
    }

    /// Shuffles with a generator of our own, so that the map is the same on every machine.
    static void shuffle(std::vector<std::size_t> &row, std::uint32_t &number)
    {
        for (std::size_t i = row.size(); i > 1; --i) {
            number = number * 1664525U + 1013904223U;
            std::swap(row[i - 1], row[(number >> 16U) % i]);
        }
    }

    /// Sorts each row by the means of the positions of what its items are joined with, in the row above or below.
    void sortRows(Rows &rows, bool isDownwards) const
    {
        std::vector<double> at = positions(rows);
        std::vector<std::pair<double, std::size_t>> sorted;
        for (std::size_t n = 0; n < rows.size(); ++n) {
            std::vector<std::size_t> &row = rows[isDownwards ? n : rows.size() - 1 - n];
            sorted.clear();
            for (const std::size_t item : row) {
                const RowItem &one = m_items[item];
                sorted.emplace_back(mean(isDownwards ? one.above : one.below, at).value_or(at[item]), item);
            }
            std::stable_sort(sorted.begin(), sorted.end(),
                             [](const auto &a, const auto &b) { return a.first < b.first; });
            std::transform(sorted.begin(), sorted.end(), row.begin(),
                           [](const auto &one) { return one.second; });
            notePositions(row, at);
        }
    }

    /// Swaps items side by side as long as that makes crossings fewer.
    void swapNeighbours(Rows &rows) const
    {
        std::vector<double> at = positions(rows);
        bool isBetter = true;
        for (int round = 0; round < sweeps && isBetter; ++round) {
            isBetter = false;
            for (std::vector<std::size_t> &row : rows) {
                for (std::size_t i = 1; i < row.size(); ++i) {
                    if (crossingsSaved(row[i - 1], row[i], at) <= 0)
                        continue;
                    std::swap(row[i - 1], row[i]);
                    isBetter = true;
                }
                notePositions(row, at);
            }
        }
    }

    /// Returns by how much the crossings become fewer if `left` and `right` change places.
    int crossingsSaved(std::size_t left, std::size_t right, const std::vector<double> &at) const
    {
        int saved = 0;
        const auto count = [&](const std::vector<std::size_t> &ofLeft,
                               const std::vector<std::size_t> &ofRight) {
            for (const std::size_t a : ofLeft) {
                for (const std::size_t b : ofRight)
                    saved += (at[a] > at[b] ? 1 : 0) - (at[a] < at[b] ? 1 : 0);
            }
        };
        count(m_items[left].above, m_items[right].above);
        count(m_items[left].below, m_items[right].below);
        return saved;
    }

    static std::optional<double> mean(const std::vector<std::size_t> &items, const std::vector<double> &at)
    {
        if (items.empty())
            return {};
        double sum = 0.0;
        for (const std::size_t item : items)
            sum += at[item];
        return sum / static_cast<double>(items.size());
    }

    // The places

    double distance(std::size_t left, std::size_t right) const
    {
        if (m_items[left].isNode && m_items[right].isNode)
            return 1.0;
        return m_items[left].isNode || m_items[right].isNode ? LayeredLayout::passing
                                                             : LayeredLayout::alongside;
    }

    /// Returns the least distance of each item of a row from the first.
    std::vector<double> offsets(const std::vector<std::size_t> &row) const
    {
        std::vector<double> all(row.size(), 0.0);
        for (std::size_t i = 1; i < row.size(); ++i)
            all[i] = all[i - 1] + distance(row[i - 1], row[i]);
        return all;
    }

    void choosePlaces()
    {
        for (const std::vector<std::size_t> &row : m_rows)
            m_width = std::max(m_width, offsets(row).back());
        for (const std::vector<std::size_t> &row : m_rows) {
            const std::vector<double> least = offsets(row);
            for (std::size_t i = 0; i < row.size(); ++i)
                m_items[row[i]].x = least[i] + (m_width - least.back()) / 2.0;
        }
        for (int i = 0; i < sweeps; ++i) {
            for (std::size_t n = 0; n < m_rows.size(); ++n)
                placeRow(m_rows[i % 2 == 0 ? n : m_rows.size() - 1 - n]);
        }
    }

    /// Moves each item of a row as close as possible to the mean place of its neighbours in other rows.
    void placeRow(const std::vector<std::size_t> &row)
    {
        std::vector<double> at(m_items.size());
        std::transform(m_items.begin(), m_items.end(), at.begin(), [](const RowItem &one) { return one.x; });
        const std::vector<double> least = offsets(row);
        // With y = x - least, the distances are kept if y does not decrease: the best such y pools its violators.
        struct Block
        {
            double sum = 0.0;
            std::size_t count = 0;
            double value() const { return sum / static_cast<double>(count); }
        };
        std::vector<Block> blocks;
        for (std::size_t i = 0; i < row.size(); ++i) {
            std::vector<std::size_t> joined = m_items[row[i]].above;
            joined.insert(joined.end(), m_items[row[i]].below.begin(), m_items[row[i]].below.end());
            blocks.push_back({mean(joined, at).value_or(m_width / 2.0) - least[i], 1});
            while (blocks.size() > 1 && blocks[blocks.size() - 2].value() > blocks.back().value()) {
                const Block last = blocks.back();
                blocks.pop_back();
                blocks.back().sum += last.sum;
                blocks.back().count += last.count;
            }
        }
        std::size_t i = 0;
        for (const Block &block : blocks) {
            const double y = std::clamp(block.value(), 0.0, m_width - least.back());
            for (std::size_t n = 0; n < block.count; ++n, ++i)
                m_items[row[i]].x = y + least[i];
        }
    }

    const std::vector<std::vector<std::size_t>> &m_restsOn;
    const int m_most;
    std::vector<std::vector<std::size_t>>
        m_bases; ///< the edges: those of m_restsOn that do not follow from others
    std::vector<std::vector<std::size_t>> m_followers; ///< the same edges from the other end
    std::vector<RowItem> m_items;                      ///< the nodes come first
    Rows m_rows;
    std::vector<std::pair<LayeredLayout::Edge, std::vector<std::size_t>>> m_edges; ///< with the items between
    double m_width = 0.0;
};

}

LayeredLayout layeredLayout(const std::vector<std::vector<std::size_t>> &restsOn, int mostInRow)
{
    return restsOn.empty() ? LayeredLayout() : Layering(restsOn, mostInRow).result();
}

}
