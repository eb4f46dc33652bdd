#pragma once

#include "sim/effect.h"
#include "sim/effects/slope.h"

#include <algorithm>
#include <vector>

namespace sim {

/// One directed link: `mover` is pulled, `anchor` is what it is pulled to (or by).
struct Link
{
    int mover = 0;
    int anchor = 0;
};

/// Links ordered by mover, and among one mover's in the order given: the order in which its pulls are added up.
class Links
{
public:
    explicit Links(std::vector<Link> links) : m_links(std::move(links))
    {
        std::stable_sort(m_links.begin(), m_links.end(),
                         [](const Link &a, const Link &b) { return a.mover < b.mover; });
    }

    /// Calls `visit(link)` for each link whose mover is in `movers` and feels forces.
    template <class Visit>
    void forEach(const State &state, Points movers, Visit &&visit) const
    {
        const auto before = [](const Link &link, int point) { return link.mover < point; };
        auto link = std::lower_bound(m_links.begin(), m_links.end(), movers.first, before);
        for (; link != m_links.end() && link->mover < movers.end(); ++link) {
            if (state.feels(link->mover))
                visit(*link);
        }
    }

    int count(const State &state, Points movers) const
    {
        int total = 0;
        forEach(state, movers, [&](const Link &) { ++total; });
        return total;
    }

private:
    std::vector<Link> m_links;
};

/// Adds `scale * pull(link)` for each link of `movers`, link after link: the batch loop of every force between
/// two points.
template <class Pull>
void addPulls(const Links &links, const State &state, Points movers, double scale, Eigen::ArrayX2d &into,
              Pull &&pull)
{
    links.forEach(state, movers, [&](const Link &link) {
        const Vec2 a = state.inverseMass[link.mover] * pull(link);
        into(link.mover, 0) += scale * a.x;
        into(link.mover, 1) += scale * a.y;
    });
}

/// The same for how pulls change: `slope(link)` is how that of one link changes with the place of its mover; with
/// that of its anchor it changes by the opposite.
template <class SlopeOf>
void addPullSlopes(const Links &links, const State &state, Points movers, double scale, Slopes &into,
                   SlopeOf &&slope)
{
    links.forEach(state, movers, [&](const Link &link) {
        addSlopeBetween(into, link.mover, link.anchor, (scale * state.inverseMass[link.mover]) * slope(link));
    });
}

/// What the links of `mover` compute: every number when it is one link, only the sum when there are several. The
/// last number is what addPulls() adds: a mass takes its share of it.
template <class ExplainLink>
std::vector<Live> explainLinks(const Links &links, const State &state, int mover, ExplainLink &&explainLink)
{
    std::vector<Live> last;
    Vec2 sum;
    int count = 0;
    links.forEach(state, {mover, 1}, [&](const Link &link) {
        last = explainLink(link);
        Vec2 &pull = std::get<Vec2>(last.back().value);
        pull = state.inverseMass[mover] * pull;
        sum = sum + pull;
        ++count;
    });
    if (count > 1)
        return {{"pull", sum}};
    return last;
}

}
