#include "sim/effects/links.h"

#include <numeric>
#include <utility>

namespace sim {

namespace {

std::vector<Link> byMover(std::vector<Link> links)
{
    std::stable_sort(links.begin(), links.end(),
                     [](const Link &a, const Link &b) { return a.mover < b.mover; });
    return links;
}

/// Counts links by their ends: the anchors of each mover in ascending order, one mover after the other.
class Ends
{
public:
    /// `links`: ordered by mover.
    explicit Ends(const std::vector<Link> &links)
    {
        const int last = links.empty() ? -1 : links.back().mover;
        m_begins.assign(static_cast<std::size_t>(last + 2), 0);
        m_anchors.reserve(links.size());
        for (const Link &link : links) {
            ++m_begins[static_cast<std::size_t>(link.mover + 1)];
            m_anchors.push_back(link.anchor);
        }
        std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
        for (int mover = 0; mover <= last; ++mover)
            std::sort(at(mover), at(mover + 1));
    }

    std::ptrdiff_t many(int mover, int anchor)
    {
        if (mover + 1 >= static_cast<int>(m_begins.size()))
            return 0;
        const auto found = std::equal_range(at(mover), at(mover + 1), anchor);
        return found.second - found.first;
    }

private:
    std::vector<int>::iterator at(int mover)
    {
        return m_anchors.begin() + m_begins[static_cast<std::size_t>(mover)];
    }

    std::vector<std::ptrdiff_t> m_begins; ///< where each mover's begin, and where the last one's end
    std::vector<int> m_anchors;
};

}

Links::Links(std::vector<Link> links) : m_links(byMover(std::move(links))), m_runs(m_links)
{
    Ends ends(m_links);
    m_answered.reserve(m_links.size());
    for (const Link &link : m_links)
        m_answered.push_back(ends.many(link.mover, link.anchor) == ends.many(link.anchor, link.mover));
}

}
