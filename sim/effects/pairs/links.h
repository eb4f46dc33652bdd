#pragma once

#include "sim/scene/effect.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace sim {

/// One directed link: `mover` is pulled, `anchor` is what it is pulled to (or by).
struct Link
{
    int mover = 0;
    int anchor = 0;
    friend bool operator==(const Link &, const Link &) = default;
};

/// Two points of which the first, or both, feel a pull between them.
struct PointPair
{
    int mover = 0;
    int anchor = 0;
    int index = 0;             ///< which numbers (stiffness, length, ...) are its own
    bool isReciprocal = false; ///< whether the anchor feels the exact opposite in the same moment
};

/// Links that all have the same numbers, as pairs.
std::vector<PointPair> pairsOf(const std::vector<Link> &links);

/// Neighbouring pairs of a PairList whose points follow each other in memory, so that a loop over them runs in vector
/// registers.
struct PairBatch
{
    enum class Shape {
        row,    ///< from pair to pair both the mover and the anchor are one farther
        fan,    ///< one mover, and anchors one after the other
        listed, ///< any points: they are read from the list
    };
    Shape shape = Shape::listed;
    int mover = 0;  ///< of the first pair
    int anchor = 0; ///< of the first pair
    int first = 0;  ///< the first pair's place in the list
    int count = 0;
    bool isReciprocal = false; ///< of all of them, unless they are listed

    /// Whether no point is both a mover and an anchor of this row: then the order of its sums does not matter.
    bool isDisjoint() const { return mover + count <= anchor || anchor + count <= mover; }
};

/// Pairs in the order in which they are computed, divided into batches.
struct PairList
{
    std::vector<PointPair> pairs;
    std::vector<PairBatch> batches; ///< each pair is in one
    std::vector<PointRange> ranges; ///< the points that the pairs pull, in ascending order
};

/// The links of a force. Links that lead to and fro between two points are one pair, computed once.
class Links
{
public:
    /// `links` in the order in which each point's pulls are added up. `areMutual`: whether the link back from an anchor
    /// to its mover has the exactly opposite pull, if it has the same numbers: `sameNumbers(a, b)` compares Pair::number.
    template <class SameNumbers>
    Links(std::vector<PointPair> links, bool areMutual, SameNumbers &&sameNumbers)
        : m_pairs(areMutual ? merged(links, sameNumbers) : links), m_links(std::move(links))
    {
        index();
    }

    /// The first link of `mover` or a higher one.
    std::vector<PointPair>::const_iterator firstOf(int mover) const;
    /// One mover after the other, and of one mover in the order given.
    const std::vector<PointPair> &links() const { return m_links; }
    /// One more than the highest point.
    int points() const { return m_points; }
    /// Each two points once, in the order in which pulls are computed.
    const std::vector<PointPair> &pairs() const { return m_pairs; }

    /// The pairs between points of `runs`, which are in ascending order and hold all points that are tied to any of
    /// theirs, in batches: the order of each point's pulls stays. `areMutual` as above: lets batches turn pairs round.
    PairList batches(const std::vector<PointRange> &ranges, bool areMutual) const;

private:
    template <class SameNumbers>
    static std::vector<PointPair> merged(const std::vector<PointPair> &links, SameNumbers &&sameNumbers)
    {
        std::vector<int> byEnds(links.size()); // sorted by mover, then anchor, then place
        for (std::size_t i = 0; i < links.size(); ++i)
            byEnds[i] = static_cast<int>(i);
        const auto at = [&](int i) -> const PointPair & { return links[static_cast<std::size_t>(i)]; };
        std::sort(byEnds.begin(), byEnds.end(), [&](int a, int b) {
            return std::tuple(at(a).mover, at(a).anchor, a) < std::tuple(at(b).mover, at(b).anchor, b);
        });
        std::vector<PointPair> pairs;
        std::vector<char> isTaken(links.size(), 0);
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (isTaken[i] != 0)
                continue;
            isTaken[i] = 1;
            PointPair pair = links[i];
            const std::pair back{pair.anchor, pair.mover};
            auto other = std::lower_bound(byEnds.begin(), byEnds.end(), back, [&](int a, const auto &ends) {
                return std::pair(at(a).mover, at(a).anchor) < ends;
            });
            for (; !pair.isReciprocal && pair.mover != pair.anchor && other != byEnds.end() &&
                   std::pair(at(*other).mover, at(*other).anchor) == back;
                 ++other) {
                char &taken = isTaken[static_cast<std::size_t>(*other)];
                if (taken == 0 && !at(*other).isReciprocal && sameNumbers(pair.index, at(*other).index)) {
                    taken = 1;
                    pair.isReciprocal = true;
                }
            }
            pairs.push_back(pair);
        }
        return pairs;
    }

    void index();

    std::vector<PointPair> m_pairs;
    std::vector<PointPair> m_links; ///< sorted by mover
    std::vector<int> m_byMover;     ///< places in m_pairs, sorted by mover
    int m_points = 0;
};

}
