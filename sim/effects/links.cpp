#include "sim/effects/links.h"

#include <utility>

namespace sim {

namespace {

std::vector<Link> byMover(std::vector<Link> links)
{
    std::stable_sort(links.begin(), links.end(),
                     [](const Link &a, const Link &b) { return a.mover < b.mover; });
    return links;
}

}

Links::Links(std::vector<Link> links) : m_links(byMover(std::move(links))), m_runs(m_links)
{
    std::vector<std::pair<int, int>> ends;
    for (const Link &link : m_links)
        ends.emplace_back(link.mover, link.anchor);
    std::sort(ends.begin(), ends.end());
    const auto many = [&](int mover, int anchor) {
        const auto found = std::equal_range(ends.begin(), ends.end(), std::pair(mover, anchor));
        return found.second - found.first;
    };
    for (const Link &link : m_links)
        m_answered.push_back(many(link.mover, link.anchor) == many(link.anchor, link.mover));
}

}
