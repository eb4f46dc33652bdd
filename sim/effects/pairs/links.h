#pragma once

#include "sim/scene/effect.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace sim {

/// A directed link. The point `mover` is pulled towards the point `anchor`, or pushed away from it.
struct Link
{
    int mover = 0;
    int anchor = 0;
    friend bool operator==(const Link &, const Link &) = default;
};

/// Two points with a pull between them. The mover feels it, and the anchor too if the pair is reciprocal.
struct PointPair
{
    int mover = 0;
    int anchor = 0;
    int index = 0;             ///< index of the numbers of this pair (stiffness, length, ...)
    bool isReciprocal = false; ///< whether the anchor feels the exactly opposite pull at the same time
};

/// Returns `links` as pairs that share the numbers with index 0.
std::vector<PointPair> pairsOf(const std::vector<Link> &links);

/// Neighbouring pairs of a PairList. In a row and in a fan the points are consecutive in memory, so the
/// compiler can vectorise the loop over them.
struct PairBatch
{
    enum class Shape {
        row,    ///< mover and anchor both increase by 1 from pair to pair
        fan,    ///< all pairs have the same mover, and the anchor increases by 1
        listed, ///< arbitrary points, read from PairList::pairs
    };
    Shape shape = Shape::listed;
    int mover = 0;  ///< mover of the first pair
    int anchor = 0; ///< anchor of the first pair
    int first = 0;  ///< index of the first pair in PairList::pairs
    int count = 0;
    /// Whether all pairs are reciprocal; for Shape::listed, whether the first one is.
    bool isReciprocal = false;

    /// Returns whether no point of this row is both a mover and an anchor. The order of additions does not
    /// matter then.
    bool isDisjoint() const { return mover + count <= anchor || anchor + count <= mover; }
};

/// Pairs in the order in which they are computed, divided into batches.
struct PairList
{
    std::vector<PointPair> pairs;
    std::vector<PairBatch> batches; ///< each pair belongs to exactly one batch
    std::vector<PointRange> ranges; ///< ranges that contain the points of all pairs, in ascending order
};

/// The links of a force. Two opposite links between the same points can become one reciprocal pair, computed
/// once.
class Links
{
public:
    /// Takes `links` in the order in which the pulls on each point are added. `isSymmetric`: whether two
    /// opposite links with equal numbers have exactly opposite pulls. They become one reciprocal pair then.
    /// `sameNumbers(a, b)` returns whether the numbers with the indices a and b are equal; see
    /// PointPair::index.
    template <class SameNumbers>
    Links(std::vector<PointPair> links, bool isSymmetric, SameNumbers &&sameNumbers)
        : m_pairs(isSymmetric ? merged(links, sameNumbers) : links), m_links(std::move(links))
    {
        buildIndex();
    }

    /// Returns the first link in links() whose mover is at least `mover`.
    std::vector<PointPair>::const_iterator firstOf(int mover) const;
    /// Returns all links, sorted by mover. Links with the same mover keep their given order.
    const std::vector<PointPair> &links() const { return m_links; }
    /// Returns the highest point index of all links, plus 1.
    int points() const { return m_points; }
    /// Returns each pair once, in the order in which the pulls are computed.
    const std::vector<PointPair> &pairs() const { return m_pairs; }

    /// Returns the pairs between points of `ranges`, in batches that keep the order of the pulls on each
    /// point. The ranges are in ascending order and hold complete islands. `isSymmetric`: as above. The
    /// batches may then swap the mover and the anchor of reciprocal pairs.
    PairList batches(const std::vector<PointRange> &ranges, bool isSymmetric) const;

private:
    /// Returns `links` with each two opposite links of equal numbers merged into one reciprocal pair.
    template <class SameNumbers>
    static std::vector<PointPair> merged(const std::vector<PointPair> &links, SameNumbers &&sameNumbers)
    {
        // Indices in `links`, sorted by mover, then by anchor, then by index.
        std::vector<int> byEnds(links.size());
        for (std::size_t i = 0; i < links.size(); ++i)
            byEnds[i] = static_cast<int>(i);
        const auto at = [&](int i) -> const PointPair & { return links[static_cast<std::size_t>(i)]; };
        std::sort(byEnds.begin(), byEnds.end(), [&](int a, int b) {
            return std::tuple(at(a).mover, at(a).anchor, a) < std::tuple(at(b).mover, at(b).anchor, b);
        });
        std::vector<PointPair> pairs;
        std::vector<char> isHandled(links.size(), 0);
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (isHandled[i] != 0)
                continue;
            isHandled[i] = 1;
            PointPair pair = links[i];
            const std::pair reverse{pair.anchor, pair.mover};
            auto other =
                std::lower_bound(byEnds.begin(), byEnds.end(), reverse, [&](int a, const auto &ends) {
                    return std::pair(at(a).mover, at(a).anchor) < ends;
                });
            for (; !pair.isReciprocal && pair.mover != pair.anchor && other != byEnds.end() &&
                   std::pair(at(*other).mover, at(*other).anchor) == reverse;
                 ++other) {
                char &isOtherHandled = isHandled[static_cast<std::size_t>(*other)];
                if (isOtherHandled == 0 && !at(*other).isReciprocal &&
                    sameNumbers(pair.index, at(*other).index)) {
                    isOtherHandled = 1;
                    pair.isReciprocal = true;
                }
            }
            pairs.push_back(pair);
        }
        return pairs;
    }

    void buildIndex();

    std::vector<PointPair> m_pairs;
    std::vector<PointPair> m_links; ///< sorted by mover
    std::vector<int> m_byMover;     ///< indices in m_pairs, sorted by mover
    int m_points = 0;
};

}
